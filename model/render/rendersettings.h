// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/render/camerakeys.h"
#include "model/sequence/axes.h"

#include <optional>

namespace quadrille {

/// How a picture looks.
struct RenderOptions
{
    enum class Shading
    {
        Textured,  ///< with light; clay where there is no texture
        Flat,      ///< the texture's own colours, no light
        Clay,      ///< one warm grey
        Wireframe, ///< triangles' edges over clay
    };
    enum class Background
    {
        Light,
        Dark,
        Transparent,
    };

    int width = 1280; ///< pixels
    int height = 720;
    int supersampling = 2; ///< samples per pixel and direction, 1 … 4
    Shading shading = Shading::Textured;
    Background background = Background::Dark;
    bool grid = true; ///< the ground with lines one metre apart; never on a transparent background
    bool shadow = true;
    /// Where the ground lies; empty: at the lowest point of the sequence.
    std::optional<double> groundHeight;
    /// What the sequence is in: which axis is up, how long a metre is.
    CoordinateSystem axes;

    bool operator==(const RenderOptions&) const = default;
};

/// What the camera does while a clip plays.
enum class CameraMode
{
    Turntable, ///< follows the figure and turns around it
    Fixed,     ///< stands still and sees the whole clip
    Follow,    ///< keeps its distance to the figure
};

/// Pictures and videos of a clip.
struct RenderSettings
{
    RenderOptions look;
    CameraMode camera = CameraMode::Turntable;
    double revolutions = 1; ///< of the turntable over the clip
    /// Where the camera stands at the first frame; empty: where it frames the figure.
    std::optional<Camera> view;
    /// Where it stands over the clip; where there are any, they take the place of what is above.
    std::vector<CameraKey> keys;

    bool operator==(const RenderSettings&) const = default;
};

} // namespace quadrille
