// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/monotonecurve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

double innerSlope(double widthBefore, double widthAfter, double before, double after)
{
    if (before * after <= 0)
        return 0;
    const double weightBefore = 2 * widthAfter + widthBefore;
    const double weightAfter = widthAfter + 2 * widthBefore;
    return (weightBefore + weightAfter) / (weightBefore / before + weightAfter / after);
}

double endSlope(double width, double nextWidth, double secant, double nextSecant)
{
    const double slope = ((2 * width + nextWidth) * secant - width * nextSecant) / (width + nextWidth);
    if (slope * secant <= 0)
        return 0;
    if (secant * nextSecant < 0 && std::abs(slope) > 3 * std::abs(secant))
        return 3 * secant;
    return slope;
}

} // namespace

MonotoneCurve::MonotoneCurve(std::vector<Vec2d> points) : m_points(std::move(points))
{
    assert(m_points.size() >= 2);
    const std::size_t spans = m_points.size() - 1;
    std::vector<double> widths(spans);
    std::vector<double> secants(spans);
    for (std::size_t i = 0; i < spans; ++i) {
        const Vec2d step = m_points[i + 1] - m_points[i];
        widths[i] = step.x();
        secants[i] = step.y() / step.x();
    }
    m_slopes.assign(spans + 1, secants[0]);
    if (spans == 1)
        return;
    m_slopes.front() = endSlope(widths[0], widths[1], secants[0], secants[1]);
    m_slopes.back() = endSlope(widths[spans - 1], widths[spans - 2], secants[spans - 1], secants[spans - 2]);
    for (std::size_t i = 1; i < spans; ++i)
        m_slopes[i] = innerSlope(widths[i - 1], widths[i], secants[i - 1], secants[i]);
}

double MonotoneCurve::operator()(double x) const
{
    if (x <= m_points.front().x())
        return m_points.front().y();
    if (x >= m_points.back().x())
        return m_points.back().y();
    const auto after = std::ranges::upper_bound(m_points, x, {}, [](const Vec2d& p) { return p.x(); });
    const auto i = static_cast<std::size_t>(after - m_points.begin()) - 1;
    const double width = m_points[i + 1].x() - m_points[i].x();
    const double t = (x - m_points[i].x()) / width;
    const double rise = m_points[i + 1].y() - m_points[i].y();
    const double first = m_slopes[i] * width;
    const double last = m_slopes[i + 1] * width;
    return m_points[i].y() + t * (first + t * (3 * rise - 2 * first - last + t * (first + last - 2 * rise)));
}

} // namespace quadrille
