// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/motionspaceentry.h"

namespace quadrille::test {

/// With every key that is known.
inline MotionSpaceEntry fullMotionSpace()
{
    MotionSpaceEntry entry;
    entry.name = "chatting";
    entry.character = "liam";
    SpaceTakeEntry take;
    take.sequence = "talk";
    take.range = FrameRange{FrameIndex(1), FrameIndex(30)};
    take.isMirrored = true;
    take.isReversed = true;
    take.speed = 1.5;
    take.place = {0.75};
    SpaceTakeEntry other;
    other.sequence = "softly";
    entry.takes = {take, other};
    SpaceParameterEntry parameter;
    parameter.name = "left hand";
    parameter.measure = SpaceMeasure::Height;
    parameter.vertex = 12;
    entry.parameters = {parameter};
    entry.reference = "softly";
    entry.cycles = false;
    entry.tolerance = 0.01;
    entry.mostReferences = 7;
    return entry;
}

} // namespace quadrille::test
