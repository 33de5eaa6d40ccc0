// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewport.h"

#include "widgets/theme/theme.h"
#include "widgets/viewport/axesgizmo.h"
#include "widgets/viewport/groundgrid.h"
#include "widgets/viewport/viewportprivate.h"
#include "widgets/viewport/vtkview.h"

#include <QEvent>
#include <QLabel>
#include <QMetaMethod>
#include <QVBoxLayout>
#include <algorithm>
#include <vtkRenderWindow.h>

namespace quadrille::widgets {

SceneFigure* Viewport::Private::find(int id)
{
    const auto it = scene.figures().find(id);
    return it == scene.figures().end() ? nullptr : &it->second;
}

std::optional<std::pair<QVector3D, QVector3D>> Viewport::Private::bounds(std::optional<int> only) const
{
    std::optional<std::pair<QVector3D, QVector3D>> box;
    for (const auto& [id, figure] : scene.figures()) {
        if (only ? id != *only : !figure.visible)
            continue;
        const bool wholeTake = figure.extent && followed != id;
        const QVector3D lower =
            (wholeTake ? figure.extent->first : figure.actor->lowerBound()) + figure.shift();
        const QVector3D upper =
            (wholeTake ? figure.extent->second : figure.actor->upperBound()) + figure.shift();
        if (!box)
            box.emplace(lower, upper);
        for (int axis = 0; axis < 3; ++axis) {
            box->first[axis] = std::min(box->first[axis], lower[axis]);
            box->second[axis] = std::max(box->second[axis], upper[axis]);
        }
    }
    const bool isInPlace = !only || (followed != only && (only == anchor || scene.figures().size() == 1));
    if (const auto marks = scene.markBounds(); marks && isInPlace) {
        if (!box)
            box = marks;
        for (int axis = 0; axis < 3; ++axis) {
            box->first[axis] = std::min(box->first[axis], marks->first[axis]);
            box->second[axis] = std::max(box->second[axis], marks->second[axis]);
        }
    }
    return box;
}

Annotations Viewport::Private::annotations() const
{
    Annotations result;
    result.measured = measured;
    result.ruler = scene.ruler();
    result.notice = notice;
    const int up = gestures->camera().upAxis == UpAxis::Y ? 1 : 2;
    for (const auto& [id, figure] : scene.figures()) {
        if (!figure.visible)
            continue;
        for (const SceneLabel& label : figure.ghostLabels)
            result.labels.push_back({label.place + figure.shift(), label.text, label.color});
        if (namesVisible && !figure.name.isEmpty()) {
            QVector3D place = (figure.actor->lowerBound() + figure.actor->upperBound()) / 2.0F;
            place[up] = figure.actor->upperBound()[up];
            result.names.push_back({place + figure.shift(), figure.name, figure.color});
        }
        if (scene.shading() != Shading::Scalar || !figure.actor->hasScalars() || result.legend || result.key)
            continue;
        if (figure.colorKey)
            result.key = figure.colorKey;
        else
            result.legend = figure.scalarRange;
    }
    result.namesListed = layout == Layout::Overlay && result.names.size() > 1;
    for (const SceneMarks* marks : scene.marks()) {
        result.labels.insert(result.labels.end(), marks->labels.begin(), marks->labels.end());
        result.handles.insert(result.handles.end(), marks->handles.begin(), marks->handles.end());
    }
    if (std::ranges::any_of(result.labels, &SceneLabel::beside)) {
        for (const auto& [id, figure] : scene.figures()) {
            if (figure.visible)
                result.figures.emplace_back(figure.actor->lowerBound() + figure.shift(),
                                            figure.actor->upperBound() + figure.shift());
        }
    }
    if (!result.isEmpty())
        result.camera = gestures->camera();
    return result;
}

Viewport::Viewport(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    setObjectName(QStringLiteral("viewport"));
    setAccessibleName(tr("Viewport"));
    setFocusPolicy(Qt::StrongFocus);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    if (VtkView::openGlAvailable()) {
        d->view = new VtkView(this);
        d->view->setObjectName(QStringLiteral("viewportSurface"));
        d->scene.attachTo(d->view->renderWindow());
        connect(d->view, &VtkView::rendered, this, &Viewport::rendered);
        connect(d->view, &VtkView::qualityChanged, this, [this](const RenderQuality& quality) {
            d->scene.shadows().setCoarseness(quality.shadowCoarseness);
            d->scene.setPixelRatio(d->view->pixelRatio());
        });
        d->surface = d->view;
    } else {
        d->excuse = new QLabel(this);
        d->excuse->setObjectName(QStringLiteral("noOpenGl"));
        d->excuse->setAlignment(Qt::AlignCenter);
        d->excuse->setWordWrap(true);
        d->excuse->setMargin(24);
        d->surface = d->excuse;
    }
    box->addWidget(d->surface);
    setFocusProxy(d->surface);
    d->gestures = new ViewGestures(d->surface);
    d->surface->installEventFilter(this); // after the gestures, so that a tool gets events before them
    d->overlay = new ViewportOverlay(this);
    d->axes = new AxesGizmo(this);
    d->axes->setVisible(isWorking());
    connect(d->axes, &AxesGizmo::lookRequested, this, &Viewport::lookFrom);
    connect(d->gestures, &ViewGestures::cameraChanged, this, [this] {
        d->scene.setCamera(d->gestures->camera());
        redraw();
        emit cameraChanged();
    });
    connect(d->gestures, &ViewGestures::clicked, this, &Viewport::click);
    connect(d->gestures, &ViewGestures::doubleClicked, this, [this](const QPointF& position) {
        if (const auto hit = pick(position)) {
            Turntable camera = d->gestures->destination();
            camera.target = hit->point;
            d->gestures->moveTo(camera);
        }
    });
    connect(d->gestures, &ViewGestures::hovered, this, [this](const QPointF& position) {
        if (!isSignalConnected(QMetaMethod::fromSignal(&Viewport::hovered)))
            return;
        const auto hit = pick(position);
        if (hit || d->hovering)
            emit hovered(hit);
        d->hovering = hit.has_value();
    });
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        d->scene.updateColors();
        redraw();
    });
    QEvent retranslate(QEvent::LanguageChange);
    changeEvent(&retranslate);
}

Viewport::~Viewport() = default;

bool Viewport::isWorking() const
{
    return d->view != nullptr;
}

void Viewport::setMoving(bool moving)
{
    if (d->view != nullptr)
        d->view->setMoving(moving);
}

VtkView* Viewport::view() const
{
    return d->view;
}

void Viewport::redraw()
{
    if (d->view != nullptr) {
        d->scene.setPixelRatio(d->view->pixelRatio());
        d->view->scheduleRender();
    }
    d->axes->setCamera(d->gestures->camera());
    if (d->viewTool)
        d->viewTool->setView(d->gestures->camera(), d->surface->size());
    d->overlay->show(d->annotations());
}

void Viewport::setMarks(const QString& layer, const SceneMarks& marks)
{
    d->scene.setMarks(layer, marks);
    redraw();
}

void Viewport::setShading(Shading shading)
{
    d->scene.setShading(shading);
    redraw();
}

Shading Viewport::shading() const
{
    return d->scene.shading();
}

void Viewport::setLayoutMode(Layout layout)
{
    if (d->layout == layout)
        return;
    d->layout = layout;
    arrange();
}

Viewport::Layout Viewport::layoutMode() const
{
    return d->layout;
}

void Viewport::setGridVisible(bool visible)
{
    d->scene.ground().setVisible(visible);
    redraw();
}

bool Viewport::isGridVisible() const
{
    return d->scene.ground().isVisible();
}

void Viewport::setShadowMaker(ShadowMaker maker)
{
    d->scene.shadows().setMaker(std::move(maker));
    redraw();
}

void Viewport::setShadowsVisible(bool visible)
{
    d->scene.shadows().setVisible(visible);
    redraw();
}

bool Viewport::areShadowsVisible() const
{
    return d->scene.shadows().isVisible();
}

void Viewport::setGhostsVisible(bool visible)
{
    d->scene.setGhostsVisible(visible);
    redraw();
}

void Viewport::setTrajectoriesVisible(bool visible)
{
    d->scene.setTrajectoriesVisible(visible);
    redraw();
}

void Viewport::setNamesVisible(bool visible)
{
    d->namesVisible = visible;
    redraw();
}

void Viewport::setNotice(const QString& text)
{
    if (d->notice == text)
        return;
    d->notice = text;
    setAccessibleDescription(text);
    redraw();
}

const QString& Viewport::notice() const
{
    return d->notice;
}

void Viewport::setUpAxis(UpAxis axis)
{
    Turntable camera = d->gestures->camera();
    if (camera.upAxis == axis)
        return;
    // The same view of the same figure, turned with the axes.
    const QVector3D t = camera.target;
    camera.target = axis == UpAxis::Z ? QVector3D(t.x(), -t.z(), t.y()) : QVector3D(t.x(), t.z(), -t.y());
    camera.upAxis = axis;
    d->gestures->setCamera(camera);
    d->scene.updateColors();
    redraw();
}

void Viewport::setRuler(const Ruler& ruler)
{
    if (ruler == d->scene.ruler())
        return;
    Turntable camera = d->gestures->camera();
    const double scale = d->scene.ruler().metresPerUnit() / ruler.metresPerUnit();
    camera.target *= static_cast<float>(scale);
    camera.distance *= static_cast<float>(scale);
    d->scene.setRuler(ruler);
    d->gestures->setCamera(camera);
    clearMeasurement();
    arrange();
}

const Ruler& Viewport::ruler() const
{
    return d->scene.ruler();
}

void Viewport::setGroundHeight(float height)
{
    if (d->groundHeight == height)
        return;
    d->groundHeight = height;
    d->scene.setGroundHeight(height);
    redraw();
    emit groundHeightChanged(height);
}

float Viewport::groundHeight() const
{
    return d->groundHeight;
}

} // namespace quadrille::widgets

#include "moc_viewport.cpp"
