// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewportscene.h"

#include "widgets/theme/theme.h"
#include "widgets/viewport/blendingrenderer.h"
#include "widgets/viewport/groundgrid.h"
#include "widgets/viewport/markactors.h"
#include "widgets/viewport/scenecamera.h"
#include "widgets/viewport/viewport.h"
#include "widgets/viewport/vtkbuffers.h"

#include <algorithm>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkCullerCollection.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

namespace quadrille::widgets {

namespace {

constexpr double trajectoryWidth = 2.5; // logical pixels
/// Share of light missing in the darkest shadow, as in exported pictures.
constexpr double shadowOnDark = 0.62;
constexpr double shadowOnLight = 0.46;
/// How much brighter the ground is than the background.
constexpr double floorOnDark = 0.10;
constexpr double floorOnLight = 0.32;

} // namespace

struct ViewportScene::Private
{
    struct Trajectory
    {
        vtkNew<vtkActor> actor;
    };

    vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::Take(newBlendingRenderer());
    FigureLights lights;
    std::unique_ptr<GroundGrid> ground;
    std::unique_ptr<SceneShadows> shadows;
    std::map<int, Trajectory> trajectories;
    struct Layer
    {
        SceneMarks marks;
        std::unique_ptr<MarkActors> actors;
    };
    std::map<QString, Layer> layers;

    QVector3D up() const { return camera.upAxis == UpAxis::Y ? QVector3D(0, 1, 0) : QVector3D(0, 0, 1); }
    /// A metre upwards.
    QVector3D lift() const { return ruler.of(1.0F) * up(); }
    Shading shading = Shading::Textured;
    Turntable camera;
    Ruler ruler;
    double pixels = 1.0; ///< of the screen for one logical pixel
    bool ghostsVisible = true;
    bool trajectoriesVisible = true;
};

ViewportScene::ViewportScene() : d(std::make_unique<Private>())
{
    d->renderer->SetAutomaticLightCreation(false);
    d->renderer->GetCullers()->RemoveAllItems(); // a handful of figures: asking for their bounds costs more
    // The figures' own shaders light them; with a light VTK hands them the normals.
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    d->renderer->AddLight(light);
    d->renderer->AddObserver(vtkCommand::StartEvent, this, &ViewportScene::prepare);
    d->ground = std::make_unique<GroundGrid>(d->renderer);
    d->shadows = std::make_unique<SceneShadows>(d->renderer);
    updateColors();
    setCamera(Turntable{});
}

ViewportScene::~ViewportScene() = default;

void ViewportScene::attachTo(vtkRenderWindow* window)
{
    window->AddRenderer(d->renderer);
}

void ViewportScene::setCamera(const Turntable& camera)
{
    d->camera = camera;
    const auto distance = static_cast<double>(camera.distance);
    constexpr double nearest = 0.002; // metres
    constexpr double beyond = 400.0;
    lookWith(d->renderer, camera, std::max(d->ruler.of(nearest), distance * 0.02),
             distance * 4.0 + d->ruler.of(beyond));
    d->ground->follow(camera);
    d->lights.follow(camera);
    sortGhosts(camera);
}

/// What is left for the moment in which a picture is drawn.
void ViewportScene::prepare()
{
    d->shadows->update(m_figures, d->camera);
}

void ViewportScene::sortGhosts(const Turntable& camera)
{
    std::vector<std::pair<float, GhostActor*>> ghosts;
    for (auto& [id, figure] : m_figures)
        for (auto& ghost : figure.ghosts)
            ghosts.emplace_back(
                QVector3D::dotProduct(ghost->centroid() - camera.position(), camera.forward()), ghost.get());
    const auto farther = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::stable_sort(ghosts.begin(), ghosts.end(), farther);
    for (auto& [depth, ghost] : ghosts)
        ghost->moveToFront();
}

void ViewportScene::updateColors()
{
    updateBackground(d->renderer);
    const bool isDark = Theme::color(ColorRole::ViewportBottom).lightnessF() < 0.5F;
    d->shadows->setStrength(isDark ? shadowOnDark : shadowOnLight);
    d->ground->setFloor(isDark ? floorOnDark : floorOnLight);
    d->ground->follow(d->camera);
    d->ground->setColors(Theme::color(ColorRole::Grid), Theme::color(ColorRole::AxisX),
                         Theme::color(d->camera.upAxis == UpAxis::Y ? ColorRole::AxisZ : ColorRole::AxisY));
    for (auto& [id, figure] : m_figures)
        refresh(figure);
    for (auto& [name, layer] : d->layers)
        layer.actors->show(layer.marks, d->lift(), d->pixels);
}

void ViewportScene::setShading(Shading shading)
{
    d->shading = shading;
    for (auto& [id, figure] : m_figures)
        figure.actor->setShading(shading);
}

Shading ViewportScene::shading() const
{
    return d->shading;
}

GroundGrid& ViewportScene::ground()
{
    return *d->ground;
}

SceneShadows& ViewportScene::shadows()
{
    return *d->shadows;
}

void ViewportScene::setRuler(const Ruler& ruler)
{
    d->ruler = ruler;
    d->ground->setRuler(ruler);
    setCamera(d->camera);
    for (auto& [id, figure] : m_figures)
        refresh(figure);
    for (auto& [name, layer] : d->layers)
        layer.actors->show(layer.marks, d->lift(), d->pixels);
}

const Ruler& ViewportScene::ruler() const
{
    return d->ruler;
}

void ViewportScene::setGroundHeight(float height)
{
    d->ground->setHeight(height);
    d->shadows->setGround(height);
    d->ground->follow(d->camera);
}

void ViewportScene::setPixelRatio(double pixels)
{
    if (d->pixels == pixels)
        return;
    d->pixels = pixels;
    d->ground->setPixelRatio(pixels);
    for (auto& [id, figure] : m_figures)
        refresh(figure);
    for (auto& [name, layer] : d->layers)
        layer.actors->show(layer.marks, d->lift(), pixels);
}

SceneFigure& ViewportScene::add(int id, FigureMesh mesh, const QString& name)
{
    SceneFigure& figure = m_figures[id];
    figure.actor = std::make_unique<FigureActor>(d->renderer, d->lights, std::move(mesh));
    figure.name = name;
    figure.actor->setShading(d->shading);
    refresh(figure);
    return figure;
}

void ViewportScene::remove(int id)
{
    setTrajectory(id, {}, {});
    d->shadows->remove(id);
    m_figures.erase(id);
}

void ViewportScene::refresh(SceneFigure& figure)
{
    figure.actor->setOffset(figure.shift());
    figure.actor->setVisible(figure.visible);
    figure.actor->setLineWidth(d->pixels);
    figure.actor->setColors(figure.color.isValid() ? figure.color : Theme::color(ColorRole::Clay),
                            Theme::color(ColorRole::Wire));
    for (const auto& ghost : figure.ghosts) {
        ghost->setOffset(figure.shift());
        ghost->setVisible(figure.visible && d->ghostsVisible);
    }
    for (const auto& [id, other] : m_figures)
        if (&other == &figure)
            applyTrajectory(id);
}

void ViewportScene::setGhosts(SceneFigure& figure, const std::vector<Ghost>& ghosts)
{
    figure.ghosts.clear();
    figure.ghostLabels.clear();
    for (const Ghost& ghost : ghosts) {
        figure.ghosts.push_back(std::make_unique<GhostActor>(d->renderer, d->lights, figure.actor->mesh(),
                                                             ghost.positions, ghost.color));
        if (ghost.label.isEmpty())
            continue;
        QColor mark = ghost.color;
        mark.setAlpha(255);
        figure.ghostLabels.push_back({figure.ghosts.back()->head(d->up()), ghost.label, mark});
    }
    refresh(figure);
    sortGhosts(d->camera);
}

void ViewportScene::setGhostsVisible(bool visible)
{
    d->ghostsVisible = visible;
    for (auto& [id, figure] : m_figures)
        refresh(figure);
    sortGhosts(d->camera);
}

void ViewportScene::applyTrajectory(int id)
{
    const auto line = d->trajectories.find(id);
    if (line == d->trajectories.end())
        return;
    const SceneFigure& figure = m_figures.at(id);
    // A little above the ground, or the grid would flicker through.
    constexpr float lift = 0.004F; // metres
    line->second.actor->SetPosition(vtkbuffers::xyz(figure.shift() + lift * d->lift()).data());
    line->second.actor->SetVisibility(figure.visible && d->trajectoriesVisible ? 1 : 0);
    line->second.actor->GetProperty()->SetLineWidth(static_cast<float>(trajectoryWidth * d->pixels));
}

void ViewportScene::setTrajectory(int id, const std::vector<QVector3D>& points, const QColor& color)
{
    if (const auto old = d->trajectories.find(id); old != d->trajectories.end()) {
        d->renderer->RemoveActor(old->second.actor);
        d->trajectories.erase(old);
    }
    if (points.size() < 2)
        return;
    vtkNew<vtkPoints> coordinates;
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell(static_cast<int>(points.size()));
    for (const QVector3D& point : points)
        lines->InsertCellPoint(coordinates->InsertNextPoint(vtkbuffers::xyz(point).data()));
    vtkNew<vtkPolyData> line;
    line->SetPoints(coordinates);
    line->SetLines(lines);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(line);
    vtkActor* actor = d->trajectories[id].actor;
    actor->SetMapper(mapper);
    const auto rgb = vtkbuffers::rgb(color.isValid() ? color : Theme::color(ColorRole::Accent));
    actor->GetProperty()->SetColor(rgb[0], rgb[1], rgb[2]);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    d->renderer->AddActor(actor);
    applyTrajectory(id);
}

void ViewportScene::setTrajectoriesVisible(bool visible)
{
    d->trajectoriesVisible = visible;
    for (const auto& [id, figure] : m_figures)
        applyTrajectory(id);
}

void ViewportScene::setMarks(const QString& layer, const SceneMarks& marks)
{
    if (marks.isEmpty()) {
        d->layers.erase(layer);
        return;
    }
    Private::Layer& own = d->layers[layer];
    if (!own.actors)
        own.actors = std::make_unique<MarkActors>(d->renderer);
    own.marks = marks;
    own.actors->show(marks, d->lift(), d->pixels);
}

std::optional<std::pair<QVector3D, QVector3D>> ViewportScene::markBounds() const
{
    std::optional<std::pair<QVector3D, QVector3D>> box;
    for (const auto& [name, layer] : d->layers) {
        for (const SceneCurve& curve : layer.marks.curves) {
            for (const QVector3D& point : curve.points) {
                if (!box)
                    box.emplace(point, point);
                for (int axis = 0; axis < 3; ++axis) {
                    box->first[axis] = std::min(box->first[axis], point[axis]);
                    box->second[axis] = std::max(box->second[axis], point[axis]);
                }
            }
        }
    }
    return box;
}

std::vector<const SceneMarks*> ViewportScene::marks() const
{
    std::vector<const SceneMarks*> all;
    for (const auto& [name, layer] : d->layers)
        all.push_back(&layer.marks);
    return all;
}

QImage ViewportScene::draw(vtkRenderWindow* window, const QSize& size, double ratio, bool background)
{
    const double pixelsBefore = d->pixels;
    setPixelRatio(ratio);
    const int* current = window->GetSize();
    const QSize before(current[0], current[1]);
    const bool gradient = d->renderer->GetGradientBackground();
    double color[3];
    d->renderer->GetBackground(color);
    if (!background) {
        d->renderer->SetGradientBackground(false);
        d->renderer->SetBackground(0.0, 0.0, 0.0);
        d->renderer->SetBackgroundAlpha(0.0);
    }
    window->SetSize(size.width(), size.height());
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, pixels);
    const QImage view(pixels->GetPointer(0), size.width(), size.height(), qsizetype{4} * size.width(),
                      background ? QImage::Format_RGBX8888 : QImage::Format_RGBA8888_Premultiplied);
    QImage picture = view.mirrored();
    d->renderer->SetGradientBackground(gradient);
    d->renderer->SetBackground(color);
    window->SetSize(before.width(), before.height());
    setPixelRatio(pixelsBefore);
    return background ? picture.convertToFormat(QImage::Format_RGB32)
                      : picture.convertToFormat(QImage::Format_ARGB32);
}

} // namespace quadrille::widgets
