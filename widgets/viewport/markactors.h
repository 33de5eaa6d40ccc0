// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/scenemarks.h"

#include <memory>

class vtkRenderer;

namespace quadrille::widgets {

/// Draws the curves and areas of marks. New marks reuse the actors of those before them, so that a drag costs
/// no more than filling some buffers.
class MarkActors
{
public:
    explicit MarkActors(vtkRenderer* renderer);
    ~MarkActors();
    MarkActors(const MarkActors&) = delete;
    MarkActors& operator=(const MarkActors&) = delete;

    /// \param metre   upwards from the ground that areas lie on, in the unit of the marks.
    /// \param pixels  of the screen for one logical pixel.
    void show(const SceneMarks& marks, const QVector3D& metre, double pixels);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
