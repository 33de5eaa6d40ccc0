// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/latent/latentscene.h"

#include "widgets/theme/theme.h"
#include "widgets/viewport/scenecamera.h"
#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace quadrille::widgets {

namespace {

constexpr double learnedWidth = 3.0; // logical pixels
constexpr double sampleWidth = 1.2;
constexpr double chosenExtra = 1.5;
constexpr double cloudSize = 7.0;
constexpr double cloudOpacity = 0.16;

vtkIdType insert(vtkPoints* points, const QVector3D& point)
{
    return points->InsertNextPoint(vtkbuffers::xyz(point).data());
}

void insert(vtkUnsignedCharArray* colors, const QColor& color)
{
    colors->InsertNextTuple3(color.red(), color.green(), color.blue());
}

/// One actor without light; its colours are those of its points.
struct Drawn
{
    Drawn()
    {
        mapper->SetInputData(shape);
        mapper->SetScalarModeToUsePointData();
        actor->SetMapper(mapper);
        actor->PickableOff();
        actor->GetProperty()->LightingOff();
    }

    vtkNew<vtkPolyData> shape;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
};

} // namespace

struct LatentScene::Private
{
    vtkNew<vtkRenderer> renderer;
    std::vector<std::unique_ptr<Drawn>> paths;
    Drawn cloud;
    Drawn axes;
};

LatentScene::LatentScene() : d(std::make_unique<Private>())
{
    d->cloud.actor->GetProperty()->SetOpacity(cloudOpacity);
    d->renderer->AddActor(d->axes.actor);
    d->renderer->AddActor(d->cloud.actor);
    updateColors();
}

LatentScene::~LatentScene() = default;

void LatentScene::attachTo(vtkRenderWindow* window)
{
    window->AddRenderer(d->renderer);
}

void LatentScene::setCamera(const Turntable& camera)
{
    const auto distance = static_cast<double>(camera.distance);
    lookWith(d->renderer, camera, distance * 0.02, distance * 20.0);
}

void LatentScene::setPaths(const std::vector<LatentPath>& paths, const ScalarRange* range, double pixels,
                           int chosen)
{
    while (d->paths.size() > paths.size()) {
        d->renderer->RemoveActor(d->paths.back()->actor);
        d->paths.pop_back();
    }
    while (d->paths.size() < paths.size()) {
        d->paths.push_back(std::make_unique<Drawn>());
        d->renderer->AddActor(d->paths.back()->actor);
    }
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const LatentPath& path = paths[i];
        Drawn& drawn = *d->paths[i];
        const bool isColored = range != nullptr && path.values.size() == path.points.size();
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> line;
        vtkNew<vtkUnsignedCharArray> colors;
        colors->SetNumberOfComponents(3);
        line->InsertNextCell(static_cast<int>(path.points.size()));
        for (std::size_t p = 0; p < path.points.size(); ++p) {
            line->InsertCellPoint(insert(points, path.points[p]));
            insert(colors, isColored ? range->color(path.values[p]) : path.color);
        }
        drawn.shape->Initialize();
        drawn.shape->SetPoints(points);
        drawn.shape->SetLines(line);
        drawn.shape->GetPointData()->SetScalars(colors);
        const double width = (path.isSample ? sampleWidth : learnedWidth) +
                             (static_cast<int>(i) == chosen ? chosenExtra : 0.0);
        drawn.actor->GetProperty()->SetLineWidth(static_cast<float>(width * pixels));
    }
}

void LatentScene::setCloud(const LatentCloud& cloud, const ScalarRange& range, double pixels)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        vertices->InsertNextCell({insert(points, cloud.points[i])});
        insert(colors, range.color(cloud.values[i]));
    }
    d->cloud.shape->Initialize();
    d->cloud.shape->SetPoints(points);
    d->cloud.shape->SetVerts(vertices);
    d->cloud.shape->GetPointData()->SetScalars(colors);
    d->cloud.actor->GetProperty()->SetPointSize(static_cast<float>(cloudSize * pixels));
    d->cloud.actor->SetVisibility(cloud.points.empty() ? 0 : 1);
}

void LatentScene::setAxes(const std::array<QVector3D, 4>& edges, double pixels)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (std::size_t end = 1; end < edges.size(); ++end)
        lines->InsertNextCell({insert(points, edges[0]), insert(points, edges.at(end))});
    d->axes.shape->Initialize();
    d->axes.shape->SetPoints(points);
    d->axes.shape->SetLines(lines);
    d->axes.actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

void LatentScene::updateColors()
{
    updateBackground(d->renderer);
    const auto axes = vtkbuffers::rgb(Theme::color(ColorRole::TextMuted));
    d->axes.actor->GetProperty()->SetColor(axes[0], axes[1], axes[2]);
}

} // namespace quadrille::widgets
