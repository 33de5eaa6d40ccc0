// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/variation/parts/bodyparts.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace quadrille {

/// How much a part of the body differs between several runs of one movement.
struct PartSpread
{
    std::string part;
    /// Between variations: mean distance of a vertex from its mean over them, metres; nothing where there
    /// are fewer than two.
    std::optional<double> variations;
    std::optional<double> takes; ///< between captured takes, metres; nothing where there are fewer than two

    /// Nothing where there is nothing to compare with.
    std::optional<double> ratio() const;
};

/// The spread between variations of a movement beside the spread between captured takes of it, by the parts
/// of the body. Frame by frame, figures are laid rigidly onto each other by the vertices that belong to the
/// root alone, so that neither where they stand counts nor that limbs turn the rest against each other.
/// Spreads are those of so many runs, made larger by √(n/(n − 1)) so that few and many compare. \param
/// variations, takes  of each run frames × vertices, metres, with the same phase of the movement at the same
/// frame. \return of all parts in their order, then of the whole body, without a name. \throws Error
/// Cancelled. \pre All runs have as many frames.
std::vector<PartSpread> variationSpread(const BodyParts& parts, std::size_t vertexCount,
                                        std::span<const Positions> variations,
                                        std::span<const Positions> takes, const Progress& progress = {});

} // namespace quadrille
