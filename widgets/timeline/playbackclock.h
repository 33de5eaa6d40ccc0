// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace quadrille::widgets {

/// Says which frame is due at a time. It holds the rate by leaving frames out, never by slowing time.
/// Pure logic: times are given, in seconds on any clock that does not go back.
class PlaybackClock
{
public:
    /// \pre fps > 0.
    void setFps(double fps);
    double fps() const { return m_fps; }
    /// Frames that play, both included. \pre first ≤ last.
    void setRange(std::int64_t first, std::int64_t last);
    void setLooping(bool looping) { m_looping = looping; }
    bool isLooping() const { return m_looping; }
    /// While looping: turns round at the ends instead of starting over.
    void setBackAndForth(bool backAndForth) { m_backAndForth = backAndForth; }

    /// Starts from a frame. \param speed times the true rate; negative plays backwards. \pre speed ≠ 0.
    void start(std::int64_t frame, double now, double speed = 1.0);
    void stop() { m_started.reset(); }
    bool isPlaying() const { return m_started.has_value(); }
    double speed() const { return m_speed; }

    /// The frame that is due. At the end of the range it starts over or turns round when looping, else it
    /// stops there.
    std::int64_t frameAt(double now);
    /// Seconds until another frame is due, at least 0.
    double untilNext(double now) const;

private:
    double framesSince(double now) const;

    double m_fps = 25.0;
    std::int64_t m_first = 0;
    std::int64_t m_last = 0;
    bool m_looping = true;
    bool m_backAndForth = false;
    double m_speed = 1.0;
    std::optional<double> m_started; ///< when, while playing
    std::int64_t m_startFrame = 0;
};

} // namespace quadrille::widgets
