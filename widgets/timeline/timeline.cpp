// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timeline.h"

#include "widgets/theme/theme.h"
#include "widgets/timeline/timelinedrop.h"
#include "widgets/timeline/timelinegestures.h"
#include "widgets/timeline/timelinegrowth.h"
#include "widgets/timeline/timelinekeyboard.h"
#include "widgets/timeline/timelinepaint.h"
#include "widgets/timeline/timelinetip.h"
#include "widgets/timeline/timelinezoombar.h"

#include <QAccessible>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

Timeline::Timeline(QWidget* parent)
    : QWidget(parent)
    , m_layout(m_content)
    , m_gestures(std::make_unique<TimelineGestures>(m_layout))
    , m_keyboard(std::make_unique<TimelineKeyboard>(m_layout))
    , m_growth(std::make_unique<TimelineGrowth>(m_layout))
    , m_drop(std::make_unique<TimelineDrop>(m_content, m_layout, *m_growth))
    , m_zoomBar(new TimelineZoomBar(m_layout.scale(), this))
{
    setObjectName(QStringLiteral("timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setFont(Theme::tabularFont(font()));
    m_layout.setMetrics(fontMetrics());
    m_zoomBar->setObjectName(QStringLiteral("timelineZoomBar"));
    connect(m_zoomBar, &TimelineZoomBar::partRequested, this, [this](double first, double frames) {
        m_layout.scale().show(first, frames);
        scaleChanged();
    });
    connect(m_zoomBar, &TimelineZoomBar::fitRequested, this, &Timeline::zoomToFit);
    installEventFilter(m_drop.get());
    follow(*m_gestures);
    follow(*m_keyboard);
    followDrags();
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    QEvent retranslate(QEvent::LanguageChange);
    changeEvent(&retranslate);
    scaleChanged();
}

Timeline::~Timeline() = default;

void Timeline::follow(const TimelineIntents& intents)
{
    using Intents = TimelineIntents;
    connect(&intents, &Intents::scrubRequested, this, &Timeline::scrub);
    connect(&intents, &Intents::scrubbingChanged, this, &Timeline::scrubbingChanged);
    connect(&intents, &Intents::selectRequested, this, &Timeline::select);
    connect(&intents, &Intents::spanHovered, this, &Timeline::spanHovered);
    connect(&intents, &Intents::rangeEdited, this, &Timeline::rangeEdited);
    connect(&intents, &Intents::loopEdited, this, &Timeline::loopEdited);
    connect(&intents, &Intents::loopRemovalRequested, this, &Timeline::loopRemovalRequested);
    connect(&intents, &Intents::spanCreated, this, &Timeline::spanCreated);
    connect(&intents, &Intents::spanEdited, this, &Timeline::spanEdited);
    connect(&intents, &Intents::keyMoved, this, &Timeline::keyMoved);
    connect(&intents, &Intents::spanActivated, this, &Timeline::spanActivated);
    connect(&intents, &Intents::spanDeletionRequested, this, &Timeline::spanDeletionRequested);
    connect(&intents, &Intents::zoomRequested, this, &Timeline::zoomBy);
    connect(&intents, &Intents::fitRequested, this, &Timeline::zoomToFit);
    connect(&intents, &Intents::foldRequested, this,
            [this](const QString& track) { setFolded(track, !isFolded(track)); });
    connect(&intents, &Intents::rowEdited, this, &Timeline::editRow);
    connect(&intents, &Intents::scrollRequested, this, [this](double first) {
        m_layout.scale().scrollTo(first);
        scaleChanged();
    });
    connect(&intents, &Intents::revealRequested, this, [this](int frame) {
        m_layout.scale().reveal(frame);
        scaleChanged();
    });
}

void Timeline::followDrags()
{
    connect(m_gestures.get(), &TimelineIntents::dragChanged, this, qOverload<>(&QWidget::update));
    connect(m_gestures.get(), &TimelineIntents::keyHeld, m_growth.get(), &TimelineGrowth::holdAt);
    connect(m_gestures.get(), &TimelineIntents::dragEnded, this, [this](bool committed) {
        update();
        if (committed)
            m_growth->stop();
        else
            m_growth->takeBack();
    });
    connect(m_drop.get(), &TimelineDrop::changed, this, qOverload<>(&QWidget::update));
    connect(m_drop.get(), &TimelineDrop::framesDropped, this, &Timeline::framesDropped);
    connect(m_growth.get(), &TimelineGrowth::grown, this, [this](const QPointF& held) {
        m_gestures->holdKey(held);
        m_drop->holdAt(held);
        scaleChanged();
    });
    connect(m_growth.get(), &TimelineGrowth::takenBack, this, [this] {
        m_content.current = std::min(m_content.current, m_layout.lastFrame());
        scaleChanged();
    });
}

void Timeline::setFrameCount(int frames)
{
    m_growth->forget();
    m_content.isEmpty = frames <= 0;
    m_zoomBar->setVisible(!m_content.isEmpty);
    m_layout.scale().setFrameCount(frames); // which keeps one where there is none
    m_content.current = std::clamp(m_content.current, 0, m_layout.lastFrame());
    scaleChanged();
}

void Timeline::setFps(double fps)
{
    m_content.fps = std::max(fps, 1e-3);
    update();
}

void Timeline::setUnit(Unit unit)
{
    m_content.inSeconds = unit == Unit::Seconds;
    updateAccessibleText();
    update();
}

void Timeline::setCurrentFrame(int frame)
{
    const int inside = std::clamp(frame, 0, m_layout.lastFrame());
    if (inside == m_content.current)
        return;
    const QRect before = m_layout.playheadRect(m_content.current);
    const double first = scale().firstVisible();
    m_content.current = inside;
    m_layout.scale().reveal(inside);
    updateAccessibleText();
    if (scale().firstVisible() != first) {
        scaleChanged();
        return;
    }
    update(before);
    update(m_layout.playheadRect(inside));
    emit viewChanged();
}

void Timeline::setRange(std::optional<std::pair<int, int>> range)
{
    m_content.range = range;
    update();
}

void Timeline::setRangeEditable(bool editable)
{
    m_content.isRangeEditable = editable;
    update();
}

void Timeline::setLoop(std::optional<std::pair<int, int>> loop)
{
    m_content.loop = loop;
    update();
}

void Timeline::setTracks(std::vector<TimelineTrack> tracks)
{
    m_content.tracks = std::move(tracks);
    m_layout.setSize(size());
    m_layout.fitHeader();
    placeZoomBar();
    if (m_gestures->hovered() && !m_content.exists(*m_gestures->hovered()))
        m_gestures->hover(std::nullopt);
    if (m_content.selected && !m_content.exists(*m_content.selected))
        select(std::nullopt);
    updateGeometry();
    scaleChanged();
}

void Timeline::setSelectedSpan(const std::optional<SpanRef>& span)
{
    m_content.selected = span && m_content.exists(*span) ? span : std::nullopt;
    update();
}

void Timeline::setDropTrack(const QString& track)
{
    m_content.dropTrack = track;
    setAcceptDrops(!track.isEmpty());
}

void Timeline::setGrowing(bool growing)
{
    m_growth->setEnabled(growing);
}

void Timeline::setRows(std::vector<TimelineRow> rows)
{
    if (rows == this->rows())
        return;
    m_layout.rows().set(std::move(rows));
    updateGeometry();
    update();
}

void Timeline::setFolded(const QString& track, bool folded)
{
    TimelineRow row = m_layout.rows().of(track);
    if (std::exchange(row.isFolded, folded) != folded)
        editRow(row, true);
}

void Timeline::editRow(const TimelineRow& row, bool committed)
{
    m_layout.rows().edit(row);
    updateGeometry();
    update();
    if (committed)
        emit rowsEdited();
}

void Timeline::zoomToFit()
{
    m_layout.scale().fit();
    scaleChanged();
}

void Timeline::zoomBy(double factor)
{
    // About the playhead where it shows, else about the middle.
    const double playhead = scale().xOf(m_content.current + 0.5);
    const bool shows = playhead >= 0.0 && playhead <= scale().width();
    m_layout.scale().zoom(factor, shows ? playhead : scale().width() / 2.0);
    scaleChanged();
}

void Timeline::scrub(int frame)
{
    const int before = m_content.current;
    setCurrentFrame(frame);
    if (m_content.current != before)
        emit frameScrubbed(m_content.current);
}

void Timeline::select(const std::optional<SpanRef>& span)
{
    if (span == m_content.selected)
        return;
    m_content.selected = span;
    update();
    emit selectionChanged(span);
}

void Timeline::scaleChanged()
{
    m_zoomBar->update();
    update();
    emit viewChanged();
}

void Timeline::placeZoomBar()
{
    const QRect ruler(m_layout.rulerRect());
    m_zoomBar->setGeometry(ruler.left(), ruler.bottom() + 1, ruler.width(), TimelineZoomBar::thickness);
}

void Timeline::updateAccessibleText()
{
    const int current = m_content.current;
    if (QAccessible::isActive())
        setAccessibleDescription(
            tr("Frame %1 of %2, %3").arg(current).arg(frameCount()).arg(timeText(current / m_content.fps)));
}

bool Timeline::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (m_keyboard->comesFirst(key.key(), key.modifiers())) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::NativeGesture) {
        const auto& gesture = *static_cast<QNativeGestureEvent*>(event);
        if (gesture.gestureType() == Qt::ZoomNativeGesture) {
            m_layout.scale().zoom(1.0 + gesture.value(), gesture.position().x() - m_layout.headerWidth());
            scaleChanged();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        QToolTip::showText(help.globalPos(), timelineTip(m_layout, help.pos(), locale()), this);
        return true;
    }
    return QWidget::event(event);
}

void Timeline::paintEvent(QPaintEvent* event)
{
    QPainter painter(this);
    paintTimeline(painter, event->rect(), m_layout, m_gestures->drag(), palette(), hasFocus());
}

void Timeline::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_layout.setSize(size());
    placeZoomBar();
    scaleChanged();
}

void Timeline::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("Timeline"));
        m_zoomBar->setAccessibleName(tr("Part of the frames that shows"));
        m_zoomBar->setToolTip(tr("Drag the part to scroll and its ends to zoom; a double click shows all"));
        updateAccessibleText();
    }
    if (event->type() == QEvent::FontChange)
        m_layout.setMetrics(fontMetrics());
    QWidget::changeEvent(event);
}

void Timeline::mousePressEvent(QMouseEvent* event)
{
    m_gestures->press(event->position(), event->button(), event->modifiers());
}

void Timeline::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_gestures->isDragging())
        setCursor(m_gestures->cursorAt(event->position()));
    m_gestures->move(event->position(), event->modifiers());
}

void Timeline::mouseReleaseEvent(QMouseEvent* event)
{
    m_gestures->release(event->button());
}

void Timeline::mouseDoubleClickEvent(QMouseEvent* event)
{
    m_gestures->doubleClick(event->position(), event->button(), event->modifiers());
}

void Timeline::leaveEvent(QEvent* event)
{
    m_gestures->hover(std::nullopt);
    QWidget::leaveEvent(event);
}

void Timeline::wheelEvent(QWheelEvent* event)
{
    TimelineScale& scale = m_layout.scale();
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        const double x = event->position().x() - m_layout.headerWidth();
        scale.zoom(std::pow(1.0015, event->angleDelta().y()), x);
    } else {
        const QPoint delta = event->pixelDelta().isNull() ? event->angleDelta() / 2 : event->pixelDelta();
        const int pixels = std::abs(delta.x()) > std::abs(delta.y()) ? delta.x() : delta.y();
        scale.scrollTo(scale.firstVisible() - pixels / scale.pixelsPerFrame());
    }
    scaleChanged();
    event->accept();
}

void Timeline::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && m_gestures->isDragging())
        m_gestures->cancel();
    else if (!m_keyboard->press(event->key(), event->modifiers()))
        QWidget::keyPressEvent(event);
}

void Timeline::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const auto span = byKey ? m_content.selected : m_layout.spanAt(event->pos());
    const TimelineTrack* track =
        byKey && span ? m_content.track(span->track) : m_layout.trackAt(event->pos());
    const QString id = track == nullptr ? QString() : track->id;
    if (span)
        select(span);
    const int frame = byKey ? m_content.current : m_layout.frameAt(event->pos().x());
    const QPoint place = byKey && span ? mapToGlobal(spanRect(*span).center()) : event->globalPos();
    emit contextMenuRequested(id, span, frame, place);
}

} // namespace quadrille::widgets

#include "moc_timeline.cpp"
