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
    QVector3D centroid;
    QVector3D offset;
};

GhostActor::GhostActor(vtkRenderer* renderer, const FigureMesh& mesh, std::span<const float> positions,
                       const QColor& color)
    : d(std::make_unique<Private>())
{
    d->renderer = renderer;
    d->centroid = vtkbuffers::mean(positions);
    vtkNew<vtkFloatArray> coordinates;
    vtkNew<vtkFloatArray> normals;
    vtkbuffers::allocate(coordinates, 3, mesh.vertexCount, "Positions");
    vtkbuffers::allocate(normals, 3, mesh.vertexCount, "Normals");
    std::copy(positions.begin(), positions.end(), vtkbuffers::values(coordinates).begin());
    computeNormals(mesh, positions, vtkbuffers::values(normals));
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
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
    property->SetAmbient(0.35);
    property->SetDiffuse(0.7);
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
