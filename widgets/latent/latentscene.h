// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/latent/latentpath.h"
#include "widgets/theme/colormap.h"
#include "widgets/viewport/turntable.h"

#include <array>
#include <memory>

class vtkRenderWindow;

namespace quadrille::widgets {

/// The VTK side of a latent view: paths as lines, a cloud of coloured points, a box with its axes.
class LatentScene
{
public:
    LatentScene();
    ~LatentScene();
    LatentScene(const LatentScene&) = delete;
    LatentScene& operator=(const LatentScene&) = delete;

    void attachTo(vtkRenderWindow* window);
    void setCamera(const Turntable& camera);
    /// \param range  where given, paths that have values take its colours. \param pixels  of the screen for a
    /// logical one. \param chosen  a path that is drawn thicker; −1 for none.
    void setPaths(const std::vector<LatentPath>& paths, const ScalarRange* range, double pixels, int chosen);
    void setCloud(const LatentCloud& cloud, const ScalarRange& range, double pixels);
    /// The three edges of the box that axes are drawn along, from one corner.
    void setAxes(const std::array<QVector3D, 4>& edges, double pixels);
    /// Takes colours from the theme.
    void updateColors();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
