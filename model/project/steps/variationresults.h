// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/variationentry.h"
#include "model/project/store/result.h"
#include "model/variation/selection.h"
#include "model/variation/variationspread.h"

#include <optional>

namespace quadrille {

// What the steps of an entry of “variations” store, and what others take from it.

/// How the takes run against the reference.
Result alignmentResult(const Movement& movement);

/// What a part was learned from, and the model. \param takes  names of the takes, pre-blends included.
Result modelResult(const PartTraining& training, const GpdmLearning& learning,
                   const std::vector<std::string>& takes);
/// A model that is still being learned: what learningOf reads, without what only all of it tells; as if it
/// were stopped here.
Result modelProgressResult(const GpdmLearning& learning);
/// \pre The result is one of modelResult.
GpdmState stateOf(const Result& model);
/// All of it but the objectives of starts that did not win. \pre The result is one of modelResult.
GpdmLearning learningOf(const Result& model);

/// The latent trajectories of one part, of all sets of samples one after the other.
Result samplesResult(const std::vector<PartVariations>& sets, Eigen::Index frames, Eigen::Index dimensions);
/// \pre The result is one of samplesResult.
std::vector<RowMatrix> trajectoriesOf(const Result& samples);
/// How far samples are apart, as SampleReport has it.
struct SampleSpread
{
    double share = 0;
    bool isGuess = false;

    bool operator==(const SampleSpread&) const = default;
};
/// Of each set, what its chains reached. \pre The result is one of samplesResult.
std::vector<std::vector<SampleSpread>> spreadsOf(const Result& samples, std::size_t sets);

/// Which candidates became variations, what all of them are like, and how far those of a set are apart.
Result selectionResult(const VariationEntry& entry, const std::vector<VariationSelection>& sets,
                       const std::vector<std::vector<PartSpread>>& spreads);
/// What was judged of each set, without the clips. \pre The result is one of selectionResult of the entry.
std::vector<VariationSelection> selectionsOf(const Result& selection, const VariationEntry& entry);
/// The candidate, from 0 in its set, that became a variation; nothing where too few candidates were good.
/// \pre The result is one of selectionResult.
std::optional<int> candidateOf(const Result& selection, int number);

} // namespace quadrille
