// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/evaluation/appearanceerrors.h"

#include <optional>

namespace quadrille {

/// How well Eigen textures and Eigen warps restore textures beside naive principal components of the textures
/// as they are, with as many components (SMCAS Fig. 17–18).
struct CompactnessRow
{
    std::int64_t components = 0; ///< of both spaces together
    std::int64_t warps = 0;      ///< of them
    AppearanceErrors own;
    AppearanceErrors naive;
};

/// From one to all but one, close together where they are few: at most 18 numbers. \pre textures ≥ 2.
std::vector<std::int64_t> componentCounts(std::int64_t textures);

/// For each number of components the textures as a model of them has them, but for the rounding of its
/// components to bytes: warps that are kept, and textures aligned by what is kept.
/// \param alignment  of the textures; its aligned textures are replaced. Null where no component is a warp:
/// then both ways are one. \param components  ascending. \param textureShare  of the components, see
/// BuildAppearanceOptions.
/// \throws Error Cancelled, WriteFailed (scratch), and what reading textures and frames throws.
/// Cost: O(rows · textures² · texels); memory: some textures for each thread, the rest lies in scratch files
/// of 6 bytes a texel and texture.
std::vector<CompactnessRow> appearanceCompactness(const AppearanceSubject& subject,
                                                  TextureAlignment* alignment,
                                                  std::span<const std::int64_t> components,
                                                  double textureShare, const Progress& progress = {},
                                                  const Executor& executor = localExecutor());

/// From how many components on naive ones are better, in between where the lines cross; none where they are
/// not with as many as were tried.
/// \param gain  by how much the own representation is better in each row, ascending by `components`.
std::optional<double> crossover(std::span<const double> components, std::span<const double> gain);

} // namespace quadrille
