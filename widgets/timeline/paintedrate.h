// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

namespace quadrille::widgets {

/// Measures how many frames a second are painted while something plays. Pure logic: times are given, in
/// seconds on any clock that does not go back.
class PaintedRate
{
public:
    /// Something begins to play.
    void restart();
    /// A picture with this frame was painted.
    void painted(std::int64_t frame, double now);
    /// Different frames painted a second, the mean over the last second or a little more; none before a
    /// second of pictures was measured.
    std::optional<double> reached() const;
    /// The same where it is time to tell it, about twice a second: a number that changes with every frame
    /// cannot be read. 0 when it is not known yet.
    std::optional<double> report(double now);

private:
    std::deque<double> m_paintedAt;
    std::optional<std::int64_t> m_lastPainted;
    std::optional<double> m_reported; ///< when the rate was told last
};

} // namespace quadrille::widgets
