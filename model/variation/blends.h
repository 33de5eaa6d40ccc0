// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// The other two takes of a blend of four.
struct AcrossBlend
{
    std::size_t from = 0;             ///< take across from MovementBlend::from
    std::size_t to = 0;               ///< take across from MovementBlend::to
    std::vector<double> weights{0.5}; ///< of this pair against the first one: ascending, between 0 and 1
};

/// Takes that are blended before learning (CVS §7): two, or four at the corners of a square.
///
///     across.from ── across.to    across = 1
///          │             │
///        from ───────── to        across = 0
///      weight = 0   weight = 1
struct MovementBlend
{
    std::size_t from = 0;             ///< take with w = 0
    std::size_t to = 0;               ///< take with w = 1
    std::vector<double> weights{0.5}; ///< ascending, between 0 and 1
    std::optional<AcrossBlend> across;
};

/// A blend that is learned with the takes.
struct Preblend
{
    std::size_t blend = 0; ///< in the movement's blends
    double weight = 0;
    double across = 0; ///< 0 where two takes are blended

    bool operator==(const Preblend&) const = default;
};

/// A take, by its number, and its share in a blend.
struct BlendShare
{
    std::size_t take = 0;
    double share = 0; ///< greater than 0; all shares of a blend add up to 1

    bool operator==(const BlendShare&) const = default;
};

/// All that is learned with the takes, blend after blend: of two takes each weight, ascending; of four all
/// nodes of the grid but its corners, row by row from across = 0 on.
std::vector<Preblend> preblendsOf(std::span<const MovementBlend> blends);

/// Which takes a pre-blend is made of: on an edge of the square two.
std::vector<BlendShare> sharesOf(const MovementBlend& blend, const Preblend& point);

/// Shares of the corners of a square in a blend, those that are 0 left out.
/// \param corners  (weight, across) = (0, 0), (1, 0), (0, 1), (1, 1).
std::vector<BlendShare> squareShares(const std::array<std::size_t, 4>& corners, double weight, double across);

/// What a pre-blend is called: “walk–jog 0.5”, inside of a square “walk–jog × stroll–run 0.5 0.25”.
/// \param takes  names of the takes.
std::string preblendName(const MovementBlend& blend, const Preblend& point,
                         const std::vector<std::string>& takes);

/// \param takes  how many there are. \throws Error BadArgument (takes that there are not or that are at two
/// places of a blend, weights that do not ascend between 0 and 1).
void checkBlends(std::span<const MovementBlend> blends, std::size_t takes);

} // namespace quadrille
