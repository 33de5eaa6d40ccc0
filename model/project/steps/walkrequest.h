// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactergraph.h"
#include "model/synthesis/walks/constraints.h"

namespace quadrille {

/// What an animation asks of a walk: its names and seconds turned into frames, its lengths into metres.
/// \throws Error ProjectInvalid (frames that a sequence does not have, a label that no sequence has).
WalkConstraints walkConstraints(const AnimationEntry& animation, const CharacterGraph& graph);
/// The curve of its path alone; nothing where it has none.
std::optional<PathConstraint> pathOf(const AnimationEntry& animation, const CharacterGraph& graph);

/// What costs of a walk are counted by.
struct CostWeights
{
    double mu = 1;   ///< of edges; squared metres where there is a path, else 1
    double beta = 0; ///< of a frame of timing error
};
CostWeights costWeights(const AnimationEntry& animation, const CharacterGraph& graph);

/// The walk of spans that a file names. \throws Error ProjectInvalid.
Walk walkOf(const std::vector<WalkSpanEntry>& spans, const CharacterGraph& graph);
/// Where the walk that an animation has already starts. \throws Error ProjectInvalid.
GroundMotion startOf(const WalkEntry& entry, const CharacterGraph& graph);

/// All of an animation and its character that a walk depends on beside the graph, as text.
std::string walkSettings(const AnimationEntry& animation, const CharacterInputs& work);

} // namespace quadrille
