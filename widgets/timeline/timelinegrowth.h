// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinelayout.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

namespace quadrille::widgets {

/// Lets the ruler of a timeline go on while something is held at its end, up to about an hour.
class TimelineGrowth : public QObject
{
    Q_OBJECT
public:
    /// Disabled at first.
    /// \param layout  outlives this; its scale gets the further frames.
    explicit TimelineGrowth(TimelineLayout& layout);
    void setEnabled(bool enabled);
    /// Goes on for as long as what is held stays at the end.
    void holdAt(const QPointF& position);
    /// What was held was let go: the frames stay until others are set.
    void stop() { m_timer.stop(); }
    /// What was held is gone: the frames that came for it go, too.
    void takeBack();
    /// The frames were set anew.
    void forget() { m_framesBefore = 0; }

signals:
    /// There are more frames, and what is held is over others.
    void grown(const QPointF& held);
    void takenBack();

private:
    TimelineLayout& m_layout;
    bool m_isEnabled = false;
    QTimer m_timer;
    int m_framesBefore = 0; ///< 0 while it has not grown
    QPointF m_held;
};

} // namespace quadrille::widgets
