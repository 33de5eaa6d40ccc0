// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/rendergovernor.h"

#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr int settling = 1;   // pictures after a step that say nothing: buffers are made anew
constexpr int judging = 2;    // pictures after which a level that is too slow is left
constexpr int patience = 40;  // pictures with time left after which a better level is tried
constexpr double room = 0.85; // of the budget that a better level is expected to need at most
constexpr double unknownRatio = 1.7;
constexpr double weight = 0.3; // of the last picture in the mean

} // namespace

double RenderGovernor::budgetFor(double picturesPerSecond)
{
    constexpr double share = 0.75; // of the time from picture to picture
    constexpr double least = 8.0;
    constexpr double usual = 25.0; // pictures a second
    return std::max(least, share * 1000 / std::max(usual, picturesPerSecond));
}

RenderQuality RenderGovernor::qualityOf(int level)
{
    static constexpr std::array<RenderQuality, levels> qualities{{{4, false, 1.0, 1.0},
                                                                  {4, false, 2.0, 1.0},
                                                                  {0, true, 2.0, 1.0},
                                                                  {0, false, 2.0, 1.0},
                                                                  {0, false, 4.0, 1.0},
                                                                  {0, false, 4.0, 0.8},
                                                                  {0, false, 4.0, 0.65},
                                                                  {0, false, 4.0, 0.5}}};
    return qualities[static_cast<std::size_t>(level)];
}

void RenderGovernor::step(int by)
{
    m_from = m_level;
    m_left = m_mean;
    m_level += by;
    m_pictures = 0;
    m_roomy = 0;
}

void RenderGovernor::drawn(double milliseconds)
{
    ++m_pictures;
    if (m_pictures <= settling)
        return;
    const bool isFirst = m_pictures == settling + 1;
    m_mean = isFirst ? milliseconds : m_mean + weight * (milliseconds - m_mean);
    if (m_pictures < settling + judging)
        return;
    if (m_pictures == settling + judging && m_left > 0 && m_from != m_level) {
        const bool wentDown = m_from < m_level;
        const double ratio = wentDown ? m_left / m_mean : m_mean / m_left;
        m_ratios[static_cast<std::size_t>(std::min(m_from, m_level))] = std::max(ratio, 1.0);
    }
    if (m_mean > m_budget && m_level + 1 < levels) {
        step(1);
        return;
    }
    if (m_level == 0)
        return;
    const double ratio = m_ratios[static_cast<std::size_t>(m_level - 1)].value_or(unknownRatio);
    m_roomy = m_mean * ratio < room * m_budget ? m_roomy + 1 : 0;
    if (m_roomy >= patience)
        step(-1);
}

void RenderGovernor::rested()
{
    m_pictures = 0;
    m_from = m_level;
}

} // namespace quadrille::widgets
