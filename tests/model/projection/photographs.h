// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/projection/pinholecamera.h"
#include "model/render/renderframe.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille::test {

/// A camera of the renderer as one that was calibrated.
inline PinholeCamera pinholeOf(const Camera& camera, int width, int height)
{
    const Vec3d forward = (camera.target - camera.eye).normalized();
    const Vec3d right = forward.cross(camera.up).normalized();
    const auto [sine, cosine] = sineCosine(camera.verticalFovDegrees / 720);
    PinholeCamera pinhole{.name = "camera", .width = width, .height = height};
    pinhole.fx = pinhole.fy = height / 2.0 * cosine / sine;
    pinhole.cx = width / 2.0 - 0.5;
    pinhole.cy = height / 2.0 - 0.5;
    pinhole.rotation.row(0) = right;
    pinhole.rotation.row(1) = forward.cross(right);
    pinhole.rotation.row(2) = forward;
    pinhole.translation = -pinhole.rotation * camera.eye;
    return pinhole;
}

/// Cameras in a circle that see all of a box, each second one from higher up.
inline std::vector<Camera> ringOfCameras(const Bounds& bounds, int count, double aspect)
{
    std::vector<Camera> cameras;
    for (int c = 0; c < count; ++c) {
        const auto [sine, cosine] = sineCosine(static_cast<double>(c) / count);
        cameras.push_back(
            frameAll(bounds, {.direction = Vec3d(sine, c % 2 == 0 ? 0.1 : 0.5, cosine), .aspect = aspect}));
    }
    return cameras;
}

/// Pictures of a frame by the program's own renderer, in the texture's own colours.
inline std::vector<std::shared_ptr<const Image>> photographs(const MeshSequence& sequence, FrameIndex frame,
                                                             const std::vector<Camera>& cameras, int width,
                                                             int height)
{
    RenderOptions options{.width = width, .height = height, .supersampling = 2};
    options.shading = RenderOptions::Shading::Flat;
    options.grid = false;
    options.shadow = false;
    const FrameRenderer renderer(sequence, options);
    std::vector<std::shared_ptr<const Image>> pictures;
    for (const Camera& camera : cameras)
        pictures.push_back(std::make_shared<const Image>(renderer.render(frame, camera)));
    return pictures;
}

inline std::vector<PinholeCamera> pinholesOf(const std::vector<Camera>& cameras, int width, int height)
{
    std::vector<PinholeCamera> pinholes;
    for (const Camera& camera : cameras)
        pinholes.push_back(pinholeOf(camera, width, height));
    return pinholes;
}

} // namespace quadrille::test
