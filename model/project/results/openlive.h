// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/livegraph.h"
#include "model/live/liveorigin.h"
#include "model/project/results/projectresults.h"
#include "model/sequence/meshsequence.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// The motion spaces of a character, ready to be played; a value that several threads may hold.
struct OpenedLiveGraph
{
    std::string character;
    std::vector<std::string> spaces; ///< names, as the graph counts them
    std::string content; ///< key of what the graph is made of: the same plays the same, whatever it is called
    std::shared_ptr<const LiveGraph> graph;
    /// What the performer looks like: for each frame of each take of each space the texture of the captured
    /// frame. All have the shape of one pose, in the project's unit.
    MeshSequence look;
    double metresPerUnit = 1;

    /// The frame of the look that a provenance means.
    FrameIndex lookOf(const LiveProvenance& provenance) const;
};

using OpenedLiveGraphPointer = std::shared_ptr<const OpenedLiveGraph>;

/// Names of a character's motion spaces that have takes, in project order.
std::vector<std::string> playableSpaces(const Project& project, const std::string& character);

/// Opens the motion spaces of a character from their results, which are brought up to date first. \throws
/// Error of the step that failed; ProjectInvalid where the character has no motion space; Cancelled.
OpenedLiveGraphPointer openLiveGraph(const ProjectResults& results, const std::string& character,
                                     const Progress& progress = {});

} // namespace quadrille
