// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/movement.h"

#include <optional>
#include <vector>

namespace quadrille {

/// The other two takes of a blend of four.
struct SubjectAcross
{
    std::size_t take = 0; ///< across from VariationSubject::take
    std::size_t to = 0;   ///< across from VariationSubject::to
    double weight = 0;    ///< of this pair against the first one, 0 … 1
};

/// What is varied: a captured take, or a blend of two, or of four at the corners of a square.
struct VariationSubject
{
    std::size_t take = 0;
    std::optional<std::size_t> to; ///< the second take of a blend
    double weight = 0;             ///< of the second, 0 … 1; of both seconds of four
    std::optional<SubjectAcross> across;
};

/// The captured takes that a subject is of, in their order, with their shares.
/// \throws Error BadArgument (a take that there is not, a weight outside [0, 1], takes across from one
/// alone).
std::vector<BlendShare> capturedShares(const Movement& movement, const VariationSubject& subject);

/// A learned trajectory over a square of takes.
struct LearnedNode
{
    double weight = 0;
    double across = 0;
    std::size_t take = 0; ///< of the movement, pre-blends included
};

/// All that was learned over the square of a subject of four takes, its corners first: the nodes of a grid,
/// whatever corner it begins at; the corners alone where none was learned. \param takes  captured ones.
/// \pre The subject has a second pair.
std::vector<LearnedNode> learnedNodes(std::span<const MovementBlend> blends, std::size_t takes,
                                      const VariationSubject& subject);

/// Around which learned trajectories variations of a subject are drawn: that of a take or of a pre-blend, the
/// two next to the weight of a blend, or the four around both weights, with their shares. Inside of a square
/// learnedNodes count; on its edges, as for two takes, all that were learned between these two.
/// \return takes of the movement, pre-blends included. \throws Error as capturedShares.
std::vector<BlendShare> subjectTakes(const Movement& movement, const VariationSubject& subject);

} // namespace quadrille
