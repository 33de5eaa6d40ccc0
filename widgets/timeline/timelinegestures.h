// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelineintents.h"
#include "widgets/timeline/timelinelayout.h"

namespace quadrille::widgets {

/// What the mouse is moving.
struct TimelineDrag
{
    TimelineGrip grip;   ///< as it was at the press
    int grabbed = 0;     ///< the frame under the pointer at the press
    QPointF pressedAt;   ///< in the widget
    double showed = 0.0; ///< the first frame that showed at the press
    int first = 0;       ///< as it would be now; of a row's edge the height
    int last = 0;
    bool moved = false; ///< far enough not to be a click

    /// A track as it would be after the drag; none where that changes nothing of it.
    std::optional<TimelineTrack> applied(const TimelineTrack& track) const;
};

/// Understands presses, moves and releases of the mouse over a timeline, in pixels of its layout. It changes
/// nothing but what is dragged and hovered; all else is intents. Of a drag they come with `committed` false,
/// at the end once with true.
class TimelineGestures : public TimelineIntents
{
    Q_OBJECT
public:
    /// \param layout  outlives the gestures.
    explicit TimelineGestures(const TimelineLayout& layout) : m_layout(layout) {}

    const TimelineDrag& drag() const { return m_drag; }
    bool isDragging() const { return m_drag.grip.kind != TimelineGrip::Kind::None; }
    const std::optional<SpanRef>& hovered() const { return m_hovered; }
    /// Tells `spanHovered` where it is another.
    void hover(const std::optional<SpanRef>& span);
    /// Where nothing is dragged.
    Qt::CursorShape cursorAt(const QPointF& position) const;

    void press(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    void move(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void release(Qt::MouseButton button);
    void doubleClick(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    /// Ends a drag with the old values.
    void cancel() { finish(false); }
    /// The frames under the key that is held, if one is, are others now.
    void holdKey(const QPointF& position);

private:
    bool dragTo(const QPointF& position, bool snap);
    void emitEdit(const TimelineGrip& grip, int first, int last, bool committed);
    void finish(bool commit);

    const TimelineLayout& m_layout;
    TimelineDrag m_drag;
    std::optional<SpanRef> m_hovered;
};

} // namespace quadrille::widgets
