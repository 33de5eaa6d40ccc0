// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/axesgizmo.h"
#include "widgets/viewport/surfacepick.h"
#include "widgets/viewport/viewportprivate.h"
#include "widgets/viewport/vtkview.h"

#include <QContextMenuEvent>
#include <QCursor>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <vtkRenderWindow.h>

namespace quadrille::widgets {

void Viewport::setFollowed(std::optional<int> figure)
{
    d->followed = figure;
    if (const SceneFigure* found = figure ? d->find(*figure) : nullptr)
        d->followedCentroid = found->actor->centroid();
}

std::optional<int> Viewport::followed() const
{
    return d->followed;
}

void Viewport::setTool(Tool tool)
{
    if (d->tool == tool)
        return;
    d->tool = tool;
    if (tool == Tool::Measure)
        d->surface->setCursor(Qt::CrossCursor);
    else
        d->surface->unsetCursor();
    clearMeasurement();
    emit toolChanged(tool);
}

Viewport::Tool Viewport::tool() const
{
    return d->tool;
}

void Viewport::clearMeasurement()
{
    d->measured.clear();
    redraw();
}

void Viewport::setViewTool(ViewTool* tool)
{
    if (d->viewTool == tool)
        return;
    if (d->viewTool)
        disconnect(d->viewTool, nullptr, this, nullptr);
    d->viewTool = tool;
    d->overlay->setTool(tool);
    if (d->tool == Tool::Navigate)
        d->surface->unsetCursor();
    if (tool != nullptr) {
        connect(tool, &ViewTool::repaintRequested, d->overlay, qOverload<>(&QWidget::update));
        connect(tool, &ViewTool::cursorRequested, this, [this](Qt::CursorShape shape) {
            if (d->tool == Tool::Navigate)
                d->surface->setCursor(shape);
        });
    }
    redraw();
}

ViewTool* Viewport::viewTool() const
{
    return d->viewTool;
}

bool Viewport::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != d->surface || !d->viewTool || d->tool != Tool::Navigate)
        return QWidget::eventFilter(watched, event);
    const bool isPress = event->type() == QEvent::MouseButtonPress;
    const bool used = d->viewTool->handle(*event);
    if (used && isPress)
        d->surface->setFocus(Qt::MouseFocusReason);
    return used;
}

void Viewport::setMousePreset(MousePreset preset)
{
    d->gestures->setPreset(preset);
}

MousePreset Viewport::mousePreset() const
{
    return d->gestures->preset();
}

Turntable Viewport::camera() const
{
    return d->gestures->destination();
}

void Viewport::setCamera(const Turntable& camera)
{
    d->gestures->setCamera(camera);
}

void Viewport::frameFigure(int figure)
{
    if (const auto box = d->bounds(figure)) {
        Turntable camera = d->gestures->destination();
        camera.frame(box->first, box->second, d->surface->size());
        d->gestures->moveTo(camera);
    }
}

void Viewport::frameAll()
{
    if (!isVisible())
        d->frameWhenShown = true;
    if (const auto box = d->bounds(std::nullopt)) {
        Turntable camera = d->gestures->destination();
        camera.frame(box->first, box->second, d->surface->size());
        d->gestures->moveTo(camera);
    }
}

void Viewport::lookFrom(StandardView view)
{
    Turntable camera = d->gestures->destination();
    camera.look(view);
    d->gestures->moveTo(camera);
}

std::optional<Pick> Viewport::pick(const QPointF& position) const
{
    const Ray ray = d->gestures->camera().rayThrough(position, d->surface->size());
    std::optional<Pick> nearest;
    float distance = 0.0F;
    for (const auto& [id, figure] : d->scene.figures()) {
        if (!figure.visible)
            continue;
        const auto hit = pickSurface(figure.actor->mesh(), figure.actor->positions(), figure.shift(), ray);
        if (!hit || (nearest && hit->distance >= distance))
            continue;
        distance = hit->distance;
        nearest = Pick{id, hit->triangle, hit->vertex, hit->barycentric, hit->point};
    }
    return nearest;
}

void Viewport::click(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers)
{
    if (button == Qt::RightButton) {
        emit contextMenuRequested(d->surface->mapToGlobal(position).toPoint());
        return;
    }
    const auto hit = pick(position);
    if (d->tool == Tool::Measure && button == Qt::LeftButton) {
        if (d->measured.size() == 2)
            d->measured.clear();
        if (hit)
            d->measured.push_back(hit->point);
        redraw();
        if (d->measured.size() == 2)
            emit measured(static_cast<double>((d->measured[1] - d->measured[0]).length()) *
                          ruler().metresPerUnit());
        return;
    }
    if (hit)
        emit picked(*hit, button, modifiers);
    else
        emit missed(button);
}

QImage Viewport::snapshot(const SnapshotOptions& options)
{
    if (d->view == nullptr)
        return {};
    const QSize size = options.size.isEmpty() ? d->view->size() * d->view->devicePixelRatioF() : options.size;
    const double scale = static_cast<double>(size.height()) / std::max(1, d->view->height());
    QImage picture;
    const bool drawn = d->view->renderApart(
        [&](vtkRenderWindow* window) { picture = d->scene.draw(window, size, scale, options.background); });
    if (!drawn)
        return {};
    if (options.annotations) {
        QPainter painter(&picture);
        painter.setFont(font());
        painter.scale(scale, scale);
        paintAnnotations(painter, QSizeF(size) / scale, d->annotations());
    }
    return picture;
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    const bool opposite = event->modifiers().testFlag(Qt::ControlModifier);
    switch (event->key()) {
    case Qt::Key_F:
    case Qt::Key_Home:
        if (event->key() == Qt::Key_F && d->followed)
            frameFigure(*d->followed);
        else
            frameAll();
        break;
    case Qt::Key_1:
        lookFrom(opposite ? StandardView::Back : StandardView::Front);
        break;
    case Qt::Key_3:
        lookFrom(opposite ? StandardView::Left : StandardView::Right);
        break;
    case Qt::Key_7:
        lookFrom(opposite ? StandardView::Bottom : StandardView::Top);
        break;
    case Qt::Key_Escape:
        if (d->tool == Tool::Navigate) {
            QWidget::keyPressEvent(event);
            return;
        }
        setTool(Tool::Navigate);
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    event->accept();
}

void Viewport::contextMenuEvent(QContextMenuEvent* event)
{
    // That of the mouse comes when the button goes down: whether it is a drag is only known later.
    if (event->reason() == QContextMenuEvent::Keyboard)
        emit contextMenuRequested(mapToGlobal(rect().center()));
    event->accept();
}

void Viewport::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Viewport"));
        if (d->view != nullptr)
            d->view->setAccessibleName(tr("Three-dimensional view"));
        if (d->excuse != nullptr)
            d->excuse->setText(
                tr("There is no OpenGL 3.2 here, so nothing can be shown in three dimensions. "
                   "Install the graphics driver, or Mesa's software renderer (libgl1-mesa-dri)."));
    }
    QWidget::changeEvent(event);
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    d->overlay->setGeometry(rect());
    d->overlay->raise();
    d->axes->move(rect().bottomRight() - QPoint(d->axes->width() + 3, d->axes->height() + 3));
    d->axes->raise();
    if (d->viewTool)
        d->viewTool->setView(d->gestures->camera(), size());
    // The layout gives the surface its size only after this event.
    if (d->frameWhenShown)
        QMetaObject::invokeMethod(
            this,
            [this] {
                d->frameWhenShown = false;
                frameAll();
            },
            Qt::QueuedConnection);
}

} // namespace quadrille::widgets
