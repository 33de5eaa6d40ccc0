// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timeline.h"

#include "widgets/theme/theme.h"
#include "widgets/timeline/timelineprivate.h"
#include "widgets/timeline/timelinezoombar.h"

#include <QAccessible>
#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace quadrille::widgets {

Timeline::Timeline(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    setObjectName(QStringLiteral("timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setFont(Theme::tabularFont(font()));
    d->font = font();
    d->zoomBar = new TimelineZoomBar(d->scale, this);
    d->zoomBar->setObjectName(QStringLiteral("timelineZoomBar"));
    connect(d->zoomBar, &TimelineZoomBar::partRequested, this, [this](double first, double frames) {
        d->scale.show(first, frames);
        scaleChanged();
    });
    connect(d->zoomBar, &TimelineZoomBar::fitRequested, this, &Timeline::zoomToFit);
    constexpr int growingMilliseconds = 40;
    d->growing.setInterval(growingMilliseconds);
    connect(&d->growing, &QTimer::timeout, this, [this] { growUnder(d->held); });
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    QEvent retranslate(QEvent::LanguageChange);
    changeEvent(&retranslate);
    scaleChanged();
}

Timeline::~Timeline() = default;

void Timeline::setFrameCount(int frames)
{
    d->framesBeforeGrowing = 0;
    d->isEmpty = frames <= 0;
    d->zoomBar->setVisible(!d->isEmpty);
    d->scale.setFrameCount(frames);
    d->current = std::clamp(d->current, 0, d->scale.frameCount() - 1);
    scaleChanged();
}

int Timeline::frameCount() const
{
    return d->scale.frameCount();
}

void Timeline::setFps(double fps)
{
    d->fps = std::max(fps, 1e-3);
    update();
}

void Timeline::setUnit(Unit unit)
{
    d->unit = unit;
    updateAccessibleText();
    update();
}

Timeline::Unit Timeline::unit() const
{
    return d->unit;
}

void Timeline::setCurrentFrame(int frame)
{
    const int inside = std::clamp(frame, 0, d->scale.frameCount() - 1);
    if (inside == d->current)
        return;
    const QRect before = d->playheadRect(d->current, fontMetrics());
    const double first = d->scale.firstVisible();
    d->current = inside;
    d->scale.reveal(inside);
    updateAccessibleText();
    if (d->scale.firstVisible() != first) {
        scaleChanged();
        return;
    }
    update(before);
    update(d->playheadRect(inside, fontMetrics()));
    emit viewChanged();
}

int Timeline::currentFrame() const
{
    return d->current;
}

void Timeline::setRange(std::optional<std::pair<int, int>> range)
{
    d->range = range;
    update();
}

std::pair<int, int> Timeline::range() const
{
    return d->effectiveRange();
}

void Timeline::setRangeEditable(bool editable)
{
    d->isRangeEditable = editable;
    update();
}

void Timeline::setLoop(std::optional<std::pair<int, int>> loop)
{
    d->loop = loop;
    update();
}

std::optional<std::pair<int, int>> Timeline::loop() const
{
    return d->loop;
}

std::pair<int, int> Timeline::playedRange() const
{
    const auto [in, out] = range();
    if (!d->loop || d->loop->first > out || d->loop->second < in)
        return {in, out};
    return {std::max(in, d->loop->first), std::min(out, d->loop->second)};
}

void Timeline::setTracks(std::vector<TimelineTrack> tracks)
{
    d->tracks = std::move(tracks);
    int widest = 0;
    for (const TimelineTrack& track : d->tracks)
        widest = std::max(widest, fontMetrics().horizontalAdvance(track.title));
    constexpr int widestHeader = 150;
    constexpr int leastHeader = 76; // lanes below have titles, too
    constexpr int besideTitle = 32; // the sign that folds, and some room
    d->headerWidth = d->tracks.empty() ? 8 : std::clamp(widest + besideTitle, leastHeader, widestHeader);
    d->scale.setWidth(width() - d->headerWidth);
    d->zoomBar->setGeometry(d->headerWidth, Private::rulerHeight, width() - d->headerWidth,
                            TimelineZoomBar::thickness);
    if (d->hovered && !d->exists(*d->hovered))
        hover(std::nullopt);
    if (d->selected && !d->exists(*d->selected))
        select(std::nullopt);
    updateGeometry();
    scaleChanged();
}

const std::vector<TimelineTrack>& Timeline::tracks() const
{
    return d->tracks;
}

void Timeline::setSelectedSpan(const std::optional<SpanRef>& span)
{
    d->selected = span && d->exists(*span) ? span : std::nullopt;
    update();
}

std::optional<SpanRef> Timeline::selectedSpan() const
{
    return d->selected;
}

const TimelineScale& Timeline::scale() const
{
    return d->scale;
}

void Timeline::zoomToFit()
{
    d->scale.fit();
    scaleChanged();
}

void Timeline::zoomBy(double factor)
{
    // About the playhead where it shows, else about the middle.
    const double playhead = d->scale.xOf(d->current + 0.5);
    const bool shows = playhead >= 0.0 && playhead <= d->scale.width();
    d->scale.zoom(factor, shows ? playhead : d->scale.width() / 2.0);
    scaleChanged();
}

QRect Timeline::spanRect(const SpanRef& ref) const
{
    if (const TimelineKey* key = d->key(ref)) {
        const QRect row = trackRect(ref.track);
        return d->keyMarkRect(row, key->frame).united(d->keyPictureRect(row, key->frame));
    }
    const TimelineSpan* span = d->span(ref);
    if (const TimelineTrack* owner = d->track(ref.track);
        span != nullptr && owner->kind == TimelineTrack::Kind::Notes)
        return d->noteRect(*owner, trackRect(ref.track), *span);
    return span == nullptr ? QRect() : d->rect(trackRect(ref.track), span->first, span->last);
}

QRect Timeline::trackRect(const QString& id) const
{
    const TimelineTrack* track = d->track(id);
    return track == nullptr ? QRect() : d->row(static_cast<std::size_t>(track - d->tracks.data()));
}

QRect Timeline::rulerRect() const
{
    return {d->headerWidth, 0, width() - d->headerWidth, Private::rulerHeight};
}

int Timeline::xOfFrame(int frame) const
{
    return d->x(frame + 0.5);
}

QSize Timeline::sizeHint() const
{
    return {640, d->contentHeight()};
}

QSize Timeline::minimumSizeHint() const
{
    return {160, d->contentHeight()};
}

void Timeline::scaleChanged()
{
    d->zoomBar->update();
    update();
    emit viewChanged();
}

void Timeline::updateAccessibleText()
{
    if (QAccessible::isActive())
        setAccessibleDescription(
            tr("Frame %1 of %2, %3").arg(d->current).arg(frameCount()).arg(timeText(d->current / d->fps)));
}

QString Timeline::tipOf(const SpanRef& ref) const
{
    const QLocale shown = locale();
    if (const TimelineKey* key = d->key(ref)) {
        QString tip = tr("%1 at %2 s").arg(key->text, shown.toString(key->frame / d->fps, 'f', 2));
        if (key->obtained)
            tip +=
                QLatin1Char('\n') + tr("Obtained at %1 s, %2 s off")
                                        .arg(shown.toString(*key->obtained / d->fps, 'f', 2),
                                             shown.toString((*key->obtained - key->frame) / d->fps, 'f', 2));
        if (key->tolerance)
            tip += QLatin1Char('\n') +
                   tr("May be off by %1 s").arg(shown.toString(*key->tolerance / d->fps, 'f', 2));
        return tip;
    }
    const TimelineSpan& span = *d->span(ref);
    if (d->track(ref.track)->kind == TimelineTrack::Kind::Notes)
        return tr("%1\nFrame %2, %3 s")
            .arg(span.text)
            .arg(span.first)
            .arg(shown.toString(span.first / d->fps, 'f', 2));
    return tr("%1: frames %2 to %3 (%4 s)")
        .arg(span.text.isEmpty() ? d->track(ref.track)->title : span.text)
        .arg(span.first)
        .arg(span.last)
        .arg(shown.toString((span.last - span.first + 1) / d->fps, 'f', 2));
}

bool Timeline::event(QEvent* event)
{
    // Keys that act on what is selected come before shortcuts of the window.
    if (event->type() == QEvent::ShortcutOverride && d->selected) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        const bool moves = (key.key() == Qt::Key_Left || key.key() == Qt::Key_Right) &&
                           (key.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier));
        if (moves || key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace ||
            key.key() == Qt::Key_F2) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto& gesture = *static_cast<QNativeGestureEvent*>(event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture) {
            d->scale.zoom(1.0 + gesture.value(), gesture.position().x() - d->headerWidth);
            scaleChanged();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        bool isEdge = false;
        if (const auto ref = d->spanAt(help.pos())) {
            QToolTip::showText(help.globalPos(), tipOf(*ref), this);
        } else if (const TimelineTrack* track = d->titleAt(help.pos(), &isEdge)) {
            QToolTip::showText(help.globalPos(),
                               isEdge ? tr("Drag to size the row; a double click makes it as usual")
                                      : tr("%1: a click folds the row, another unfolds it").arg(track->title),
                               this);
        } else {
            QToolTip::hideText();
        }
        return true;
    }
    return QWidget::event(event);
}

void Timeline::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    d->paint(painter, event->rect(), *this);
}

void Timeline::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    d->size = size();
    d->scale.setWidth(width() - d->headerWidth);
    d->zoomBar->setGeometry(d->headerWidth, Private::rulerHeight, width() - d->headerWidth,
                            TimelineZoomBar::thickness);
    scaleChanged();
}

void Timeline::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Timeline"));
        d->zoomBar->setAccessibleName(tr("Part of the frames that shows"));
        d->zoomBar->setToolTip(tr("Drag the part to scroll and its ends to zoom; a double click shows all"));
        updateAccessibleText();
    }
    if (event->type() == QEvent::FontChange)
        d->font = font();
    QWidget::changeEvent(event);
}

} // namespace quadrille::widgets
