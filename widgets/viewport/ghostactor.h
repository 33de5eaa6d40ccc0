// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/figurelights.h"
#include "widgets/viewport/figuremesh.h"

#include <QColor>
#include <QVector3D>
#include <memory>

class vtkRenderer;

namespace quadrille::widgets {

/// A translucent copy of one pose of a figure.
class GhostActor
{
public:
    /// \pre three values per vertex. \param positions  are copied. \param color  its alpha is the opacity;
    /// opaque means the usual one.
    GhostActor(vtkRenderer* renderer, const FigureLights& lights, const FigureMesh& mesh,
               std::span<const float> positions, const QColor& color);
    ~GhostActor();
    GhostActor(const GhostActor&) = delete;
    GhostActor& operator=(const GhostActor&) = delete;

    /// With the offset.
    QVector3D centroid() const;
    /// The place above its middle that is as high as it is, without the offset. \param up  length one. Cost:
    /// O(vertices).
    QVector3D head(const QVector3D& up) const;
    void setOffset(const QVector3D& offset);
    void setVisible(bool visible);
    /// Ghosts blend rightly when drawn from the farthest to the nearest: draws this one last from now on.
    void moveToFront();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace quadrille::widgets
