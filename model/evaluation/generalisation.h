// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/evaluation/appearanceerrors.h"

namespace quadrille {

struct GeneralisationSettings
{
    std::vector<double> fractions; ///< of the textures, that are learned from; in (0, 1)
    std::int64_t draws = 5;        ///< of each fraction
    std::uint64_t seed = 1;
};

/// What spaces learned from some textures make of the others (SMCAS Fig. 19–20).
struct GeneralisationRow
{
    double fraction = 0;
    std::int64_t training = 0;           ///< textures that were learned from
    std::vector<AppearanceErrors> own;   ///< of the others, for each draw
    std::vector<AppearanceErrors> naive; ///< the same by principal components of textures as they are
};

/// For each fraction and draw the errors of textures left out, projected on all components of those that are
/// learned from: the aligned texture and the backward warp on spaces of such, beside the texture itself.
/// \param alignment  of all textures, made whole anew: aligned textures become those that backward warps give
/// the textures from. Null: nothing is aligned, and both ways are one.
/// \pre Two textures at least. Each fraction takes in one at least, and leaves one out.
/// \throws Error Cancelled, WriteFailed (scratch), and what reading textures and frames throws.
/// Cost: O(fractions · draws · textures² · texels); memory: see appearanceCompactness.
std::vector<GeneralisationRow> appearanceGeneralisation(const AppearanceSubject& subject,
                                                        TextureAlignment* alignment,
                                                        const GeneralisationSettings& settings,
                                                        const Progress& progress = {},
                                                        const Executor& executor = localExecutor());

} // namespace quadrille
