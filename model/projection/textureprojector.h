// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/progress.h"
#include "model/projection/atlastexels.h"
#include "model/projection/cameraview.h"
#include "model/render/shading.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// What cameras show of the texels of one frame.
struct ProjectedTexels
{
    struct Colour
    {
        std::uint8_t red = 0; ///< sRGB
        std::uint8_t green = 0;
        std::uint8_t blue = 0;
        std::uint8_t trust = 0; ///< 255 · that of the camera that is trusted most; 0: no camera sees it

        bool operator==(const Colour&) const = default;
    };
    std::vector<Colour> colours; ///< as AtlasTexels::places
    /// Per camera its share of the weights, all texels that are seen counting alike: they add up to one.
    std::vector<double> shares;
    std::int64_t seen = 0;   ///< texels that some camera sees
    std::int64_t sights = 0; ///< the same, each as often as cameras see it
};

/// Looks the texels of an atlas up in pictures of calibrated cameras: projective texturing, blended by angle
/// of view and visibility (Debevec et al., Modeling and Rendering Architecture from Photographs, 1996; SCANS
/// §5.2). Blending is done in linear light, with weights that add up to one. Safe from any thread.
class TextureProjector
{
public:
    /// \param width,height  of the textures, texels.
    /// \throws Error NoUvs; BadArgument where a camera has a fault, and as atlasTexels.
    TextureProjector(std::shared_ptr<const Topology> topology, std::vector<PinholeCamera> cameras, int width,
                     int height, const SightOptions& options = {});

    const AtlasTexels& atlas() const { return m_atlas; }
    const std::vector<PinholeCamera>& cameras() const { return m_cameras; }

    /// \param pictures  one for each camera, of its size; null where it has none of the frame.
    /// \throws Error BadArgument where positions are not finite, or a picture has another size; Cancelled.
    /// The same for any number of threads. Cost: O(cameras · (pixels + texels)); memory: 24 bytes per texel,
    /// 4 more for each camera, and 20 per pixel of one camera.
    ProjectedTexels project(Positions positions, std::span<const std::shared_ptr<const Image>> pictures,
                            const Progress& progress = {}) const;

private:
    class Sums;
    void addCamera(std::size_t camera, Positions positions, std::span<const Vec3f> normals,
                   const std::shared_ptr<const Image>& picture, Sums& sums, const Progress& progress) const;

    std::shared_ptr<const Topology> m_topology;
    std::vector<PinholeCamera> m_cameras;
    SightOptions m_options;
    AtlasTexels m_atlas;
    IncidentTriangles m_neighbours;
    std::vector<Eigen::Matrix<double, 2, 2>>
        m_steps; ///< per triangle: weights of its second and third corner
                 ///< along a step of a texel to the right and down
};

} // namespace quadrille
