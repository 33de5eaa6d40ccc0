// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/render/backdrop.h"
#include "model/render/mipmap.h"
#include "model/render/shading.h"

#include <memory>
#include <span>

namespace quadrille {

/// A mesh as it is drawn.
struct ShadedFigure
{
    Positions positions;
    std::span<const Vec3f> normals; ///< per vertex
    const TopologyData& topology;
    /// By material, with null where there is none; one that stands for all materials; or empty.
    std::span<const std::shared_ptr<const MipTexture>> textures;
};

/// Draws a figure on its backdrop.
/// \param projection of options.width × options.height × supersampling² samples.
Image drawPicture(const ShadedFigure& figure, const Projection& projection, const Lights& lights,
                  const Backdrop& backdrop, const RenderOptions& options);

} // namespace quadrille
