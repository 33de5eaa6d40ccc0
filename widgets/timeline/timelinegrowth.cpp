// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinegrowth.h"

#include <algorithm>
#include <utility>

namespace quadrille::widgets {

TimelineGrowth::TimelineGrowth(TimelineLayout& layout) : m_layout(layout)
{
    constexpr int milliseconds = 40;
    m_timer.setInterval(milliseconds);
    connect(&m_timer, &QTimer::timeout, this, [this] { holdAt(m_held); });
}

void TimelineGrowth::setEnabled(bool enabled)
{
    m_isEnabled = enabled;
    if (!enabled)
        takeBack();
}

void TimelineGrowth::holdAt(const QPointF& position)
{
    constexpr double reach = 28; // pixels before the end
    TimelineScale& scale = m_layout.scale();
    const int frames = scale.frameCount();
    const bool isAtEnd = scale.firstVisible() + scale.visibleFrames() > frames - 1 &&
                         position.x() >= m_layout.size().width() - reach;
    const int mostFrames = static_cast<int>(3600 * m_layout.content().fps);
    m_held = position;
    if (!m_isEnabled || !isAtEnd || frames >= mostFrames)
        return m_timer.stop();
    if (!m_timer.isActive())
        return m_timer.start();
    if (m_framesBefore == 0)
        m_framesBefore = frames;
    scale.setFrameCount(frames + std::max(1, frames / 100));
    scale.scrollTo(scale.frameCount());
    emit grown(position);
}

void TimelineGrowth::takeBack()
{
    m_timer.stop();
    if (m_framesBefore == 0)
        return;
    m_layout.scale().setFrameCount(std::exchange(m_framesBefore, 0));
    emit takenBack();
}

} // namespace quadrille::widgets

#include "moc_timelinegrowth.cpp"
