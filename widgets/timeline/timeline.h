// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinescale.h"

#include <QColor>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Frames first … last, both included, with a name.
struct TimelineSpan
{
    int id = 0; ///< the caller's, unique in its track
    int first = 0;
    int last = 0;
    QString text;
    QColor color;
    bool hatched = false; ///< for synthetic frames, so that colour is not the only sign
    bool operator==(const TimelineSpan&) const = default;
};

/// A row of spans.
struct TimelineTrack
{
    enum class Kind
    {
        Labels,   ///< names of spans
        Contacts, ///< slim, one row per foot
        Clips     ///< what a result is put together from
    };
    QString id; ///< the caller's, unique in the timeline
    QString title;
    Kind kind = Kind::Labels;
    bool editable = false;
    std::vector<TimelineSpan> spans;
    bool operator==(const TimelineTrack&) const = default;
};

/// Names a span by its track and its id.
struct SpanRef
{
    QString track;
    int span = 0;
    bool operator==(const SpanRef&) const = default;
};

/// Ruler, playhead, range and strips over the frames of a clip. It changes nothing itself besides the
/// frame: edits are signals, and come back by setTracks() or setRange(). While something is dragged,
/// signals come with `committed` false, at the end once with true; Escape ends with the old values.
///
/// Wheel scrolls, Ctrl+wheel and pinch zoom; ← → step, Home and End jump, + − 0 zoom, I and O set the range,
/// Insert makes a span, Up and Down select spans, Ctrl+← → move and Shift+← → stretch the selected one,
/// Delete removes it, Return names it. Dragging snaps to edges and playhead unless Alt is held.
class Timeline : public QWidget
{
    Q_OBJECT
public:
    enum class Unit
    {
        Frames,
        Seconds
    };

    explicit Timeline(QWidget* parent = nullptr);
    ~Timeline() override;

    void setFrameCount(int frames);
    int frameCount() const;
    void setFps(double fps);
    void setUnit(Unit unit);
    Unit unit() const;
    /// Emits nothing.
    void setCurrentFrame(int frame);
    int currentFrame() const;
    /// The frames that play, both included; none: all.
    void setRange(std::optional<std::pair<int, int>> range);
    std::pair<int, int> range() const;
    void setTracks(std::vector<TimelineTrack> tracks);
    const std::vector<TimelineTrack>& tracks() const;
    void setSelectedSpan(const std::optional<SpanRef>& span);
    std::optional<SpanRef> selectedSpan() const;

    const TimelineScale& scale() const;
    void zoomToFit();
    void zoomBy(double factor);
    /// Where something is drawn, in this widget's coordinates; for tests and tool tips.
    QRect spanRect(const SpanRef& span) const;
    QRect trackRect(const QString& track) const;
    QRect rulerRect() const;
    int xOfFrame(int frame) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user moved the playhead.
    void frameScrubbed(int frame);
    void scrubbingChanged(bool scrubbing);
    void rangeEdited(int first, int last, bool committed);
    void spanCreated(const QString& track, int first, int last);
    void spanEdited(const quadrille::widgets::SpanRef& span, int first, int last, bool committed);
    void selectionChanged(const std::optional<quadrille::widgets::SpanRef>& span);
    /// Double click or Return: to be renamed.
    void spanActivated(const quadrille::widgets::SpanRef& span);
    void spanDeletionAsked(const quadrille::widgets::SpanRef& span);
    /// \param span  none when there was none under the pointer.
    void contextMenuAsked(const QString& track, const std::optional<quadrille::widgets::SpanRef>& span,
                          int frame, const QPoint& globalPosition);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
    void scrub(int frame);
    void select(const std::optional<SpanRef>& span);
    void scaleChanged();
    void updateAccessibleText();
    bool editSelectedByKey(int key, Qt::KeyboardModifiers modifiers);
    void selectNeighbour(int step);
    void finishDrag(bool commit);
};

} // namespace quadrille::widgets
