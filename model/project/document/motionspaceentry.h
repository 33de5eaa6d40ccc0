// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/parametric/motionspace.h"
#include "model/project/document/unknownkeys.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A take of a motion space, and how it is performed.
struct SpaceTakeEntry
{
    std::string sequence;
    std::optional<FrameRange> range; ///< its whole, or the cycle that is found
    bool isMirrored = false;         ///< left and right exchanged
    bool isReversed = false;         ///< from its last frame to its first
    double speed = 1;                ///< in which it is played
    std::vector<double> place;       ///< on the axes by hand, a value of each parameter; measured when empty
    UnknownKeys unknown;

    bool operator==(const SpaceTakeEntry&) const = default;
};

/// What the takes of a motion space differ in.
struct SpaceParameterEntry
{
    std::string name;
    SpaceMeasure measure = SpaceMeasure::Speed;
    std::optional<std::int64_t> vertex; ///< of Height, Forward and Side
    UnknownKeys unknown;

    bool operator==(const SpaceParameterEntry&) const = default;
};

/// Takes of one kind of movement as one that parameters steer (IA4D section 3.1).
struct MotionSpaceEntry
{
    static constexpr std::size_t mostParameters = 3;

    std::string name;
    std::string character;             ///< may be left out in a file with one character
    std::vector<SpaceTakeEntry> takes; ///< at most WeightSpace::mostTakes
    std::vector<SpaceParameterEntry> parameters;
    std::string reference; ///< the sequence of the take whose frames are the space's; that of the first
    bool cycles = true;    ///< takes of locomotion are cut to one cycle, where the reference has one
    double tolerance = MotionSpaceSettings().tolerance; ///< of the hybrid blend, metres
    int mostReferences = MotionSpaceSettings().mostReferences;
    UnknownKeys unknown;

    bool operator==(const MotionSpaceEntry&) const = default;
};

/// The number of the reference among the takes; of several of its sequence the first, 0 where none is.
std::size_t referenceOf(const MotionSpaceEntry& entry);
/// Whether a parameter measures a vertex.
bool isOfVertex(SpaceMeasure measure);

} // namespace quadrille
