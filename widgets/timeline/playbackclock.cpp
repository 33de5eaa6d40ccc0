// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/playbackclock.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// Keeps a time that lies on a frame's edge, give or take rounding, on the later side.
constexpr double edge = 1e-6;

} // namespace

void PlaybackClock::setFps(double fps)
{
    assert(fps > 0);
    m_fps = fps;
}

void PlaybackClock::setRange(std::int64_t first, std::int64_t last)
{
    assert(first <= last);
    m_first = first;
    m_last = last;
}

void PlaybackClock::start(std::int64_t frame, double now, double speed)
{
    assert(speed != 0);
    m_startFrame = std::clamp(frame, m_first, m_last);
    m_started = now;
    m_speed = speed;
}

double PlaybackClock::framesSince(double now) const
{
    return std::max(0.0, now - *m_started) * m_fps * std::abs(m_speed);
}

std::int64_t PlaybackClock::frameAt(double now)
{
    if (!m_started)
        return m_startFrame;
    const auto steps = static_cast<std::int64_t>(std::floor(framesSince(now) + edge));
    const std::int64_t frame = m_startFrame + (m_speed > 0 ? steps : -steps);
    if (frame >= m_first && frame <= m_last)
        return frame;
    if (!m_looping) {
        m_startFrame = m_speed > 0 ? m_last : m_first;
        stop();
        return m_startFrame;
    }
    const std::int64_t count = m_last - m_first + 1;
    // There and back, each end is shown once.
    const std::int64_t round = m_backAndForth ? std::max<std::int64_t>(1, 2 * (count - 1)) : count;
    const std::int64_t place = ((frame - m_first) % round + round) % round;
    return m_first + (place < count ? place : round - place);
}

double PlaybackClock::untilNext(double now) const
{
    if (!m_started)
        return 0;
    const double steps = framesSince(now);
    const double next = std::floor(steps + edge) + 1;
    return std::max(0.0, (next - steps) / (m_fps * std::abs(m_speed)));
}

} // namespace quadrille::widgets
