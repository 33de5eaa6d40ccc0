// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/texturequality.h"
#include "model/core/progress.h"
#include "model/render/camera.h"
#include "model/sequence/topology.h"

#include <memory>
#include <vector>

namespace quadrille {

class MipTexture;

/// Cameras around a body, at the height of its middle, that see all of it.
/// \param count  of them, one full turn apart in equal steps, the first one in front. \pre There is a
/// position.
std::vector<Camera> ringOfCameras(Positions positions, UpAxis up, int count);

/// A frame as cameras see it with one texture, to be compared with others: its colours as they are, without
/// light, 512 × 512 pixels. Several are compared from one thread each.
class Silhouettes
{
public:
    /// \param topology  with UVs; stays where it is for as long as this lives, as do the positions.
    Silhouettes(Positions positions, const TopologyData& topology, std::vector<Camera> cameras, UpAxis up,
                const std::shared_ptr<const Image>& texture);

    /// How near pictures with another texture come to those with the first: mean over cameras, each over the
    /// pixels that the body covers. Cost: some milliseconds a camera. \throws Error Cancelled.
    PictureQuality compare(const std::shared_ptr<const Image>& texture, const Progress& progress = {}) const;

private:
    Image render(const Camera& camera, const std::shared_ptr<const MipTexture>& texture) const;

    Positions m_positions;
    const TopologyData& m_topology;
    std::vector<Camera> m_cameras;
    UpAxis m_up;
    std::vector<Vec3f> m_normals; ///< of no use without light, but asked for
    std::vector<Image> m_pictures;
    std::vector<std::vector<std::uint8_t>> m_masks; ///< of the pictures: where the body is seen
};

} // namespace quadrille
