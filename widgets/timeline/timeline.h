// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/draggedframes.h"
#include "widgets/timeline/timelinelayout.h"

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::widgets {

class TimelineDrop;
class TimelineGestures;
class TimelineGrowth;
class TimelineIntents;
class TimelineKeyboard;
class TimelineZoomBar;

/// Ruler, playhead, range and strips over the frames of a clip. It changes nothing itself besides the
/// frame: edits are signals, and come back by setTracks() or setRange(). While something is dragged,
/// signals come with `committed` false, at the end once with true; Escape ends with the old values.
///
/// Wheel scrolls, Ctrl+wheel, pinch and the ends of the bar under the ruler zoom; ← → step, Home and End
/// jump, + − 0 zoom, I and O set the range, or the loop where the range is fixed; a drag over the ruler with
/// Shift sets the loop, a click with Shift takes it away. Insert makes a span, Up and Down select spans and
/// keys, Ctrl+← → move and Shift+← → stretch the selected one, Delete removes it, Return names it. Dragging
/// snaps to edges, keys and playhead unless Alt is held. A click on the title of a row folds it, a drag of
/// the title's lower edge sizes it.
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

    /// \param frames  0: there is no clip. The playhead is kept inside.
    void setFrameCount(int frames);
    int frameCount() const { return scale().frameCount(); }
    void setFps(double fps);
    void setUnit(Unit unit);
    Unit unit() const { return m_content.inSeconds ? Unit::Seconds : Unit::Frames; }
    /// Emits nothing. Kept inside the frames there are; the view scrolls as little as needed to show it.
    /// `viewChanged` is told.
    void setCurrentFrame(int frame);
    int currentFrame() const { return m_content.current; }
    /// The frames that play, both included; none: all.
    void setRange(std::optional<std::pair<int, int>> range);
    std::pair<int, int> range() const { return m_layout.range(); }
    /// Whether the range has ends that can be moved; else I and O set the loop.
    void setRangeEditable(bool editable);
    /// The part of the range that plays again and again, both ends included; none: all of the range.
    void setLoop(std::optional<std::pair<int, int>> loop);
    std::optional<std::pair<int, int>> loop() const { return m_content.loop; }
    /// The loop as far as it lies in the range, else the range.
    std::pair<int, int> playedRange() const { return m_layout.playedRange(); }
    /// `selectionChanged` is told where the selected span goes.
    void setTracks(std::vector<TimelineTrack> tracks);
    const std::vector<TimelineTrack>& tracks() const { return m_content.tracks; }
    /// One that there is not: none. Emits nothing.
    void setSelectedSpan(const std::optional<SpanRef>& span);
    std::optional<SpanRef> selectedSpan() const { return m_content.selected; }
    /// The track of keys that frames can be dropped onto, from anywhere over the timeline; empty for none.
    void setDropTrack(const QString& track);
    /// Lets the ruler go on behind its end while a key is held there.
    void setGrowing(bool growing);
    /// Rows that are not as usual; also of tracks that are not there now.
    void setRows(std::vector<TimelineRow> rows);
    const std::vector<TimelineRow>& rows() const { return m_layout.rows().all(); }
    /// `rowsEdited` is told, as where the user folds it.
    void setFolded(const QString& track, bool folded);
    bool isFolded(const QString& track) const { return m_layout.rows().of(track).isFolded; }

    const TimelineScale& scale() const { return m_layout.scale(); }
    /// Shows all frames, and keeps doing so until it is zoomed.
    void zoomToFit();
    /// About the playhead where it shows, else about the middle; more detail above one.
    void zoomBy(double factor);
    /// Where something is drawn, in this widget's coordinates; for tests and tool tips.
    /// Of a key, its mark and picture.
    QRect spanRect(const SpanRef& span) const { return m_layout.spanRect(span); }
    QRect trackRect(const QString& track) const { return m_layout.trackRect(track); }
    QRect rulerRect() const { return m_layout.rulerRect(); }
    /// What a row is called, left of its track.
    QRect titleRect(const QString& track) const { return m_layout.titleRect(track); }
    /// The middle of a frame.
    int xOfFrame(int frame) const { return m_layout.x(frame + 0.5); }

    QSize sizeHint() const override { return {640, m_layout.contentHeight()}; }
    QSize minimumSizeHint() const override { return {160, m_layout.contentHeight()}; }

signals:
    /// Other frames are shown, or the playhead is at another one.
    void viewChanged();
    /// The user moved the playhead.
    void frameScrubbed(int frame);
    /// A drag of the playhead begins or ends.
    void scrubbingChanged(bool scrubbing);
    /// Both ends included; so for the loop and for spans.
    void rangeEdited(int first, int last, bool committed);
    void loopEdited(int first, int last, bool committed);
    void loopRemovalRequested();
    /// The user sized or folded a row; rows() has it already.
    void rowsEdited();
    /// Of a track of keys (Insert, double click): both frames are one.
    void spanCreated(const QString& track, int first, int last);
    void spanEdited(const quadrille::widgets::SpanRef& span, int first, int last, bool committed);
    void keyMoved(const quadrille::widgets::SpanRef& key, int frame, bool committed);
    /// \param track  that of setDropTrack(). \param frame  where they become a key.
    void framesDropped(const QString& track, int frame, const quadrille::widgets::DraggedFrames& frames);
    /// The span or key under the pointer is another one.
    void spanHovered(const std::optional<quadrille::widgets::SpanRef>& span);
    void selectionChanged(const std::optional<quadrille::widgets::SpanRef>& span);
    /// Double click or Return: to be renamed.
    void spanActivated(const quadrille::widgets::SpanRef& span);
    /// Delete or Backspace was pressed; nothing is taken away yet.
    void spanDeletionRequested(const quadrille::widgets::SpanRef& span);
    /// \param span  none when there was none under the pointer.
    void contextMenuRequested(const QString& track, const std::optional<quadrille::widgets::SpanRef>& span,
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
    void leaveEvent(QEvent* event) override;

private:
    void follow(const TimelineIntents& intents);
    void followDrags();
    void scrub(int frame);
    void select(const std::optional<SpanRef>& span);
    void editRow(const TimelineRow& row, bool committed);
    void scaleChanged();
    void placeZoomBar();
    void updateAccessibleText();

    TimelineContent m_content;
    TimelineLayout m_layout;
    std::unique_ptr<TimelineGestures> m_gestures;
    std::unique_ptr<TimelineKeyboard> m_keyboard;
    std::unique_ptr<TimelineGrowth> m_growth;
    std::unique_ptr<TimelineDrop> m_drop;
    TimelineZoomBar* m_zoomBar;
};

} // namespace quadrille::widgets
