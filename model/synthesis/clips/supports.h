// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/synthesis/clips/ground.h"
#include "model/transition/characterframes.h"

#include <span>
#include <vector>

namespace quadrille {

/// What of the surface stands on the ground in a frame.
struct Support
{
    std::vector<std::uint32_t> vertices; ///< ascending
    std::vector<Vec2d> places;           ///< of each on the ground, metres

    /// Mean place of some of the vertices. \pre There are any, and all of them stand.
    Vec2d meanOf(std::span<const std::uint32_t> standing) const;
};

/// The vertices of each frame that stand: of a foot that does (the sequence's contacts, or those that
/// detectContacts finds), low and slow themselves.
/// \throws Error what reading frames throws, Cancelled. Cost: O(frames · vertices).
std::vector<Support> findSupports(const CharacterFrames& character, UpAxis up, const Progress& progress = {});

/// Leaves out vertices, the same ones in every frame and evenly among all, so that about so many stand where
/// most do: some dozens tell where feet are as well as hundreds. \param most  at least 1.
void thinSupports(std::vector<Support>& supports, std::size_t most);

/// The numbers that both have, of ascending ones.
std::vector<std::uint32_t> common(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

} // namespace quadrille
