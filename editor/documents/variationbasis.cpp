// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationbasis.h"

#include <algorithm>
#include <functional>

namespace quadrille {

VariationBasis basisOf(const Project& project, const VariationEntry& entry)
{
    VariationBasis basis{.settings = project.settings,
                         .characters = project.characters,
                         .sequences = project.sequences,
                         .bodies = project.bodyParts,
                         .entry = entry};
    basis.settings.cacheMegabytes = 0;
    basis.entry.samples.clear();
    basis.entry.chain = {};
    basis.entry.extent = {};
    basis.entry.draw = {};
    basis.entry.limits = {};
    basis.entry.correctsContacts = {};
    // Labels change no frame, and sequences that are not learned from are another matter.
    const auto isLearnedFrom = [&entry](const SequenceEntry& sequence) {
        return std::ranges::find(entry.training, sequence.name, &TrainingEntry::sequence) !=
               entry.training.end();
    };
    const auto isClip = [&](const SequenceEntry& sequence) {
        return isLearnedFrom(sequence) && sequence.source.starts_with("clip:");
    };
    if (std::ranges::none_of(basis.sequences, isClip))
        std::erase_if(basis.sequences, std::not_fn(isLearnedFrom));
    for (SequenceEntry& sequence : basis.sequences)
        sequence.labels.clear();
    return basis;
}

VariationDrawing drawingOf(const VariationEntry& entry)
{
    VariationDrawing drawing{entry.samples, entry.chain,  entry.extent,
                             entry.draw,    entry.limits, entry.correctsContacts};
    for (SamplesEntry& samples : drawing.samples)
        samples.discarded.clear();
    return drawing;
}

} // namespace quadrille
