// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/colormap.h"
#include "widgets/viewport/figurelights.h"
#include "widgets/viewport/figuremesh.h"
#include "widgets/viewport/shading.h"

#include <QColor>
#include <QImage>
#include <QVector3D>
#include <memory>

class vtkRenderer;

namespace quadrille::widgets {

/// One figure in a renderer: one actor per material, which share positions and normals. Buffers are made
/// once; a new frame only overwrites them.
class FigureActor
{
public:
    /// \pre `lights` last as long as the actor.
    FigureActor(vtkRenderer* renderer, const FigureLights& lights, FigureMesh mesh);
    ~FigureActor();
    FigureActor(const FigureActor&) = delete;
    FigureActor& operator=(const FigureActor&) = delete;

    const FigureMesh& mesh() const;
    std::span<const float> positions() const;
    /// Without the offset; a degenerate box at the origin before the first positions.
    QVector3D lowerBound() const;
    QVector3D upperBound() const;
    /// The mean of all vertices, without the offset.
    QVector3D centroid() const;

    /// They are copied. Normals and bounds follow. Cost: O(vertices + triangles).
    /// \pre three values per vertex.
    void setPositions(std::span<const float> positions);
    /// A null image takes the texture away. Its pixels are shared, and copied only for formats that VTK does
    /// not take. Nothing happens for a material that there is not.
    void setTexture(const QImage& texture, int material);
    bool hasTexture() const;
    /// Colours are made at once: later changes of the range need another call.
    /// \pre one value per vertex or triangle; empty takes them away.
    void setScalars(std::span<const float> values, ScalarPlace place, const ScalarRange& range);
    /// In place of scalars. \pre one per triangle; empty takes them away.
    void setTriangleColors(std::span<const QRgb> colors);
    bool hasScalars() const;
    void setOffset(const QVector3D& offset);
    void setVisible(bool visible);
    /// 0 … 1.
    void setOpacity(double opacity);
    void setColors(const QColor& clay, const QColor& wire);
    void setShading(Shading shading);
    /// Of the wireframe. \param pixels  of the screen.
    void setLineWidth(double pixels);

private:
    struct Part;
    struct Private;
    std::unique_ptr<Private> d;
    void applyAppearance();
};

} // namespace quadrille::widgets
