// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/decode.h"
#include "model/core/progress.h"

#include <QImage>
#include <vector>

namespace quadrille {

/// An Eigen texture: its values as colours about grey, so strong that nearly all of them can be told apart;
/// transparent outside of what is used.
QImage eigenTexturePicture(const AppearanceModel& model, int index);
/// An Eigen warp over the mean texture in grey: the colour says which way texels move where there is more of
/// it, its strength how far. Right is red, down is yellow green, left is cyan, up is violet.
/// \param arrows  that say the same, side by side in the picture's width, the longest as long as they are
/// apart; none for 0.
QImage eigenWarpPicture(const AppearanceDecoder& decoder, int index, int arrows);

/// What a gallery shows of a component.
struct ComponentPicture
{
    bool isWarp = false;
    int index = 0;
    double share = 0; ///< of the variance of its space
    QImage picture;
};

/// Small pictures of all components, textures first. On threads of jobs. \param side  pixels, about.
/// \throws Error Cancelled. Cost: O(values of all components), 0.3 s for 50 of 1024².
std::vector<ComponentPicture> componentPictures(const AppearanceModel& model, int side,
                                                const Progress& progress);

/// The share of the variance that each component of a space explains, of all that its samples had.
std::vector<double> varianceShares(const QuantisedSpace& space);

} // namespace quadrille
