// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/ghostactor.h"

#include "widgets/viewport/prepassactor.h"
#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace quadrille::widgets {

struct GhostActor::Private
{
    vtkSmartPointer<vtkRenderer> renderer;
    vtkSmartPointer<vtkActor> actor;
    vtkNew<vtkFloatArray> coordinates;
    QVector3D centroid;
    QVector3D offset;
};

GhostActor::GhostActor(vtkRenderer* renderer, const FigureLights& lights, const FigureMesh& mesh,
                       std::span<const float> positions, const QColor& color)
    : d(std::make_unique<Private>())
{
    d->renderer = renderer;
    d->centroid = vtkbuffers::mean(positions);
    vtkNew<vtkFloatArray> normals;
    vtkbuffers::allocate(d->coordinates, 3, mesh.vertexCount, "Positions");
    vtkbuffers::allocate(normals, 3, mesh.vertexCount, "Normals");
    std::copy(positions.begin(), positions.end(), vtkbuffers::values(d->coordinates).begin());
    computeNormals(mesh, positions, vtkbuffers::values(normals));
    vtkNew<vtkPoints> points;
    points->SetData(d->coordinates);
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    vtkbuffers::setCells(cells, mesh.triangles);
    surface->SetPolys(cells);
    surface->GetPointData()->SetNormals(normals);

    d->actor = vtkSmartPointer<vtkActor>::Take(newPrepassActor());
    vtkNew<vtkOpenGLPolyDataMapper> mapper;
    vtkbuffers::connect(mapper, surface);
    d->actor->SetMapper(mapper);
    vtkProperty* property = d->actor->GetProperty();
    const auto rgb = vtkbuffers::rgb(color);
    property->SetColor(rgb[0], rgb[1], rgb[2]);
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    d->actor->SetShaderProperty(lights.shader(FigureLights::Surface::Clay));
    constexpr double ghostOpacity = 0.34;
    property->SetOpacity(color.alpha() < 255 ? color.alphaF() : ghostOpacity);
    renderer->AddActor(d->actor);
}

GhostActor::~GhostActor()
{
    d->renderer->RemoveActor(d->actor);
}

QVector3D GhostActor::centroid() const
{
    return d->centroid + d->offset;
}

QVector3D GhostActor::head(const QVector3D& up) const
{
    const auto values = vtkbuffers::values(d->coordinates);
    float highest = QVector3D::dotProduct(d->centroid, up);
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        highest =
            std::max(highest, QVector3D::dotProduct(QVector3D(values[i], values[i + 1], values[i + 2]), up));
    return d->centroid + (highest - QVector3D::dotProduct(d->centroid, up)) * up;
}

void GhostActor::setOffset(const QVector3D& offset)
{
    d->offset = offset;
    d->actor->SetPosition(static_cast<double>(offset.x()), static_cast<double>(offset.y()),
                          static_cast<double>(offset.z()));
}

void GhostActor::setVisible(bool visible)
{
    d->actor->SetVisibility(visible ? 1 : 0);
}

void GhostActor::moveToFront()
{
    d->renderer->RemoveActor(d->actor);
    d->renderer->AddActor(d->actor);
}

} // namespace quadrille::widgets
