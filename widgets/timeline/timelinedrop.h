// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/draggedframes.h"
#include "widgets/timeline/timelinegrowth.h"

class QDropEvent;

namespace quadrille::widgets {

/// Takes frames that are dropped over a timeline onto the content's `dropTrack`, and shows meanwhile, as
/// `dropFrame`, where they would be. An event filter of the timeline.
class TimelineDrop : public QObject
{
    Q_OBJECT
public:
    /// All outlive this.
    TimelineDrop(TimelineContent& content, const TimelineLayout& layout, TimelineGrowth& growth);
    bool eventFilter(QObject* watched, QEvent* event) override;
    /// The frames under what is held, if anything is, are others now.
    void holdAt(const QPointF& position);

signals:
    void changed();
    void framesDropped(const QString& track, int frame, const quadrille::widgets::DraggedFrames& frames);

private:
    void enter(QDropEvent& event) const;
    void move(QDropEvent& event);
    void drop(QDropEvent& event);
    int frameUnder(const QDropEvent& event) const;

    TimelineContent& m_content;
    const TimelineLayout& m_layout;
    TimelineGrowth& m_growth;
};

} // namespace quadrille::widgets
