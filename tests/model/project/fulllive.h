// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/liveentry.h"

namespace quadrille::test {

/// With every key that is known.
inline LiveEntry fullLive()
{
    LiveEntry entry;
    entry.name = "steered";
    entry.spaces = {"chatting"};
    entry.inputs = {{0, {.space = 0, .parameters = {1.25}}},
                    {31, {.space = 0, .parameters = {1, 0, 2}, .isResponsive = true}}};
    entry.ticks = 200;
    entry.from = 12;
    entry.ticksPerFrame = 3;
    entry.position = Vec2d(1, -2);
    entry.heading = 45;
    entry.depth = 9;
    entry.latencyWeight = 4;
    entry.responsiveWeight = 30;
    entry.fadeSeconds = 0.2;
    entry.secondsAcross = 1.5;
    entry.correctsContacts = false;
    return entry;
}

} // namespace quadrille::test
