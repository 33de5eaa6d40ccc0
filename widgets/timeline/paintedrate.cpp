// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/paintedrate.h"

namespace quadrille::widgets {

namespace {

constexpr double measuredSeconds = 1.0;
constexpr double secondsBetweenReports = 0.5;

} // namespace

void PaintedRate::restart()
{
    *this = {};
}

void PaintedRate::painted(std::int64_t frame, double now)
{
    if (m_lastPainted == frame)
        return;
    m_lastPainted = frame;
    m_paintedAt.push_back(now);
    while (m_paintedAt.size() > 2 && now - m_paintedAt[1] >= measuredSeconds)
        m_paintedAt.pop_front();
}

std::optional<double> PaintedRate::reached() const
{
    if (m_paintedAt.empty() || m_paintedAt.back() - m_paintedAt.front() < measuredSeconds)
        return std::nullopt;
    return static_cast<double>(m_paintedAt.size() - 1) / (m_paintedAt.back() - m_paintedAt.front());
}

std::optional<double> PaintedRate::report(double now)
{
    if (m_reported && now - *m_reported < secondsBetweenReports)
        return std::nullopt;
    m_reported = now;
    return reached().value_or(0);
}

} // namespace quadrille::widgets
