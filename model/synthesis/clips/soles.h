// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/synthesis/clips/ground.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// The vertices of one foot in one frame, and how much each of them touches the ground.
struct Sole
{
    std::vector<Vec2d> places;
    std::vector<double> weights; ///< 1 for the lowest, 0 from a fiftieth of the figure's height above it
    double height = 0;           ///< weighted mean
    Vec2d middle = Vec2d::Zero();
};

/// \pre The foot has vertices. \param figureHeight  metres; a fiftieth of it is what counts as touching.
Sole soleOf(Positions pose, std::span<const std::uint32_t> vertices, double figureHeight,
            const Ground& ground);

/// What touches the ground in two frames, as one rigid piece.
struct Touch
{
    Vec2d before = Vec2d::Zero(); ///< its middle
    Vec2d after = Vec2d::Zero();
    double turn = 0;
};

Touch touchOf(const Sole& before, const Sole& after, double figureHeight);

/// How far what touches the ground slips from one pose to the next, metres: a foot that rolls does not slip.
double soleSlip(Positions before, Positions after, std::span<const std::uint32_t> vertices,
                double figureHeight, const Ground& ground);

} // namespace quadrille
