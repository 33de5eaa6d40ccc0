// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/latent/latentview.h"

#include "widgets/latent/latentviewprivate.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/vtkview.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double reach = 10; // logical pixels from the pointer to a path

} // namespace

LatentView::LatentView(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    setObjectName(QStringLiteral("latentView"));
    setFocusPolicy(Qt::StrongFocus);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    if (VtkView::openGlAvailable()) {
        d->view = new VtkView(this);
        d->view->setObjectName(QStringLiteral("latentSurface"));
        d->scene.attachTo(d->view->renderWindow());
        d->surface = d->view;
    } else {
        auto* excuse = new QLabel(tr("The latent view needs OpenGL 3.2."));
        excuse->setObjectName(QStringLiteral("noOpenGl"));
        excuse->setAlignment(Qt::AlignCenter);
        excuse->setWordWrap(true);
        d->surface = excuse;
    }
    box->addWidget(d->surface);
    setFocusProxy(d->surface);
    d->surface->setFocusPolicy(Qt::StrongFocus);
    d->gestures = new ViewGestures(d->surface);
    d->surface->setMouseTracking(true);
    d->surface->installEventFilter(this);
    d->overlay = new Overlay(*this);
    connect(d->gestures, &ViewGestures::cameraChanged, this, [this] {
        d->scene.setCamera(d->gestures->camera());
        redraw();
    });
    connect(d->gestures, &ViewGestures::hovered, this,
            [this](const QPointF& position) { choose(placeAt(position)); });
    connect(d->gestures, &ViewGestures::clicked, this,
            [this](const QPointF& position, Qt::MouseButton button) {
                if (const auto place = placeAt(position); place && button == Qt::LeftButton) {
                    choose(place);
                    emit activated(place->path, place->frame);
                }
            });
    connect(&Theme::instance(), &Theme::changed, this, &LatentView::updateScene);
    updateScene();
}

LatentView::~LatentView() = default;

const std::vector<LatentPath>& LatentView::paths() const
{
    return d->paths;
}

void LatentView::setPaths(std::vector<LatentPath> paths)
{
    if (paths == d->paths)
        return;
    const bool wasEmpty = d->paths.empty();
    d->paths = std::move(paths);
    d->current.resize(d->paths.size());
    const auto isGone = [this](const Place& place) {
        return place.path >= static_cast<int>(d->paths.size()) || place.frame >= d->frameCount(place.path);
    };
    if (d->chosen && isGone(*d->chosen))
        choose({});
    updateScene();
    if (wasEmpty)
        frameAll();
}

void LatentView::setDimensions(int dimensions)
{
    if (dimensions == d->dimensions)
        return;
    d->dimensions = dimensions;
    if (dimensions < 3)
        lookFrom(StandardView::Front);
    updateScene();
}

void LatentView::setCurrent(std::vector<std::optional<double>> frames)
{
    frames.resize(d->paths.size());
    if (frames == d->current)
        return;
    d->current = std::move(frames);
    d->overlay->update();
}

void LatentView::setConfidence(LatentCloud cloud, const ScalarRange& range)
{
    d->cloud = std::move(cloud);
    d->range = range;
    updateScene();
}

void LatentView::setConfidenceShown(bool shown)
{
    d->isConfidenceShown = shown;
    updateScene();
}

bool LatentView::isConfidenceShown() const
{
    return d->isConfidenceShown;
}

void LatentView::setEmptyText(const QString& text)
{
    d->emptyText = text;
    redraw();
}

std::optional<LatentView::Place> LatentView::chosen() const
{
    return d->chosen;
}

QString LatentView::readOut() const
{
    if (!d->chosen)
        return {};
    const LatentPath& path = d->paths[static_cast<std::size_t>(d->chosen->path)];
    const auto frame = static_cast<std::size_t>(d->chosen->frame);
    //: a movement and one of its frames
    QString text = tr("%1, frame %2").arg(path.name).arg(d->chosen->frame);
    if (frame >= path.values.size())
        return text;
    //: a movement with its frame; a quantity and its value
    return tr("%1; %2: %3").arg(text, d->range.title, QLocale().toString(path.values[frame], 'f', 2));
}

std::optional<QPointF> LatentView::positionOf(const Place& place) const
{
    const auto& points = d->paths[static_cast<std::size_t>(place.path)].points;
    return d->project(points[static_cast<std::size_t>(place.frame)]);
}

Turntable LatentView::camera() const
{
    return d->gestures->camera();
}

void LatentView::setCamera(const Turntable& camera)
{
    d->gestures->setCamera(camera);
}

void LatentView::frameAll()
{
    Turntable camera = d->gestures->destination();
    const auto [lower, upper] = d->box();
    camera.frame(lower, upper, d->surface->size());
    d->gestures->moveTo(camera);
}

void LatentView::lookFrom(StandardView view)
{
    Turntable camera = d->gestures->destination();
    camera.look(view);
    d->gestures->moveTo(camera);
}

void LatentView::choose(std::optional<Place> place)
{
    if (place == d->chosen)
        return;
    const bool isOtherPath = !place || !d->chosen || place->path != d->chosen->path;
    d->chosen = place;
    setAccessibleDescription(isEmpty() ? d->emptyText : readOut());
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
    if (isOtherPath)
        updateScene();
    else
        d->overlay->update();
    emit chosenChanged();
}

std::optional<LatentView::Place> LatentView::placeAt(const QPointF& position) const
{
    std::optional<Place> nearest;
    double least = reach;
    for (int path = 0; path < static_cast<int>(d->paths.size()); ++path) {
        for (int frame = 0; frame < d->frameCount(path); ++frame) {
            const auto pixel = positionOf({path, frame});
            if (!pixel)
                continue;
            const double distance = std::hypot(pixel->x() - position.x(), pixel->y() - position.y());
            if (distance < least) {
                least = distance;
                nearest = Place{path, frame};
            }
        }
    }
    return nearest;
}

void LatentView::stepChosen(int paths, int frames)
{
    if (isEmpty())
        return;
    Place place = d->chosen.value_or(Place{0, 0});
    if (d->chosen) {
        const auto count = static_cast<int>(d->paths.size());
        place.path = (place.path + paths + count) % count;
        place.frame += frames;
    }
    place.frame = std::clamp(place.frame, 0, std::max(d->frameCount(place.path) - 1, 0));
    choose(place);
}

bool LatentView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && Private::isOwnKey(*static_cast<QKeyEvent*>(event))) {
        event->accept(); // in the window these mean something else
        return true;
    }
    return QWidget::event(event);
}

bool LatentView::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && Private::isOwnKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress) {
        keyPressEvent(static_cast<QKeyEvent*>(event));
        return event->isAccepted();
    }
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut)
        d->overlay->update();
    return QWidget::eventFilter(watched, event);
}

void LatentView::keyPressEvent(QKeyEvent* event)
{
    constexpr int far = 1 << 20;
    event->accept();
    switch (event->key()) {
    case Qt::Key_Left:
        return stepChosen(0, -1);
    case Qt::Key_Right:
        return stepChosen(0, 1);
    case Qt::Key_Home:
        return stepChosen(0, -far);
    case Qt::Key_End:
        return stepChosen(0, far);
    case Qt::Key_Up:
        return stepChosen(-1, 0);
    case Qt::Key_Down:
        return stepChosen(1, 0);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (d->chosen)
            emit activated(d->chosen->path, d->chosen->frame);
        return;
    case Qt::Key_F:
        return frameAll();
    case Qt::Key_1:
        return lookFrom(StandardView::Front);
    case Qt::Key_3:
        return lookFrom(StandardView::Right);
    case Qt::Key_7:
        return lookFrom(StandardView::Top);
    default:
        event->ignore();
    }
}

void LatentView::leaveEvent(QEvent* /*event*/)
{
    if (!d->surface->hasFocus())
        choose({});
}

void LatentView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    d->overlay->resize(size());
}

void LatentView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        redraw();
}

void LatentView::redraw()
{
    if (d->view != nullptr)
        d->view->scheduleRender();
    setAccessibleDescription(isEmpty() ? d->emptyText : readOut());
    d->overlay->update();
}

void LatentView::updateScene()
{
    const double pixels = d->surface->devicePixelRatioF();
    const bool isColored = d->isConfidenceShown && !isEmpty();
    d->scene.updateColors();
    d->scene.setPaths(d->paths, isColored ? &d->range : nullptr, pixels, d->chosen ? d->chosen->path : -1);
    d->scene.setCloud(isColored ? d->cloud : LatentCloud(), d->range, pixels);
    d->scene.setAxes(d->axes(), pixels);
    redraw();
}

} // namespace quadrille::widgets

#include "moc_latentview.cpp"
