// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <vector>

namespace quadrille {

/// All of a project that takes and their models depend on.
struct VariationBasis
{
    ProjectSettings settings;
    std::vector<CharacterEntry> characters;
    std::vector<SequenceEntry> sequences;
    std::vector<BodyPartsEntry> bodies;
    VariationEntry entry; ///< without what is drawn

    bool operator==(const VariationBasis&) const = default;
};

/// Equal for two projects where the same takes are aligned and the same models learned. Labels do not count,
/// nor sequences that are not learned from, unless one of these is a clip itself.
VariationBasis basisOf(const Project& project, const VariationEntry& entry);

/// What is drawn depends on these, besides the models.
struct VariationDrawing
{
    std::vector<SamplesEntry> samples;
    HmcSettings chain;
    TrajectoryLimits extent;
    PoseDraw draw = PoseDraw::Mean;
    VariationLimits limits;
    bool correctsContacts = true;

    bool operator==(const VariationDrawing&) const = default;
};

/// It does not say which variations the user discarded.
VariationDrawing drawingOf(const VariationEntry& entry);

} // namespace quadrille
