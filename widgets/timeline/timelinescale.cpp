// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/timeline/timelinescale.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille::widgets {

namespace {
constexpr double closestPixelsPerFrame = 64.0;
}

void TimelineScale::setFrameCount(int frames)
{
    m_frameCount = std::max(frames, 1);
    if (m_fitted)
        fit();
    limit();
}

void TimelineScale::setWidth(double pixels)
{
    m_width = std::max(pixels, 1.0);
    if (m_fitted)
        fit();
    limit();
}

int TimelineScale::nearestFrame(double x) const
{
    return std::clamp(static_cast<int>(std::floor(frameAt(x))), 0, m_frameCount - 1);
}

void TimelineScale::fit()
{
    m_fitted = true;
    m_first = 0.0;
    m_pixelsPerFrame = m_width / m_frameCount;
}

bool TimelineScale::isFitted() const
{
    return m_fitted;
}

void TimelineScale::zoom(double factor, double x)
{
    const double under = frameAt(x);
    const double fitted = m_width / m_frameCount;
    m_pixelsPerFrame = std::clamp(m_pixelsPerFrame * factor, fitted, std::max(fitted, closestPixelsPerFrame));
    m_fitted = m_pixelsPerFrame <= fitted * 1.0001;
    m_first = under - x / m_pixelsPerFrame;
    limit();
}

void TimelineScale::show(double firstFrame, double frames)
{
    const double fitted = m_width / m_frameCount;
    m_pixelsPerFrame =
        std::clamp(m_width / std::max(frames, 1.0), fitted, std::max(fitted, closestPixelsPerFrame));
    m_fitted = m_pixelsPerFrame <= fitted * 1.0001;
    m_first = firstFrame;
    limit();
}

void TimelineScale::scrollTo(double firstFrame)
{
    m_first = firstFrame;
    limit();
}

void TimelineScale::reveal(int frame)
{
    if (frame < m_first)
        m_first = frame;
    else if (frame + 1 > m_first + visibleFrames())
        m_first = frame + 1 - visibleFrames();
    limit();
}

void TimelineScale::limit()
{
    m_first = std::clamp(m_first, 0.0, std::max(0.0, m_frameCount - visibleFrames()));
}

int TimelineScale::frameStep(double minimumPixels) const
{
    int decade = 1;
    for (;;) {
        for (const int step : {1, 2, 5})
            if (step * decade * m_pixelsPerFrame >= minimumPixels || decade >= 100'000'000)
                return step * decade;
        decade *= 10;
    }
}

double TimelineScale::secondStep(double minimumPixels, double fps) const
{
    constexpr std::array<double, 15> steps = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1,  2,
                                              5,    10,   15,   30,  60,  120, 300};
    for (const double step : steps)
        if (step * fps * m_pixelsPerFrame >= minimumPixels)
            return step;
    return steps.back();
}

QString timeText(double seconds)
{
    const auto hundredths = static_cast<long long>(std::llround(std::max(seconds, 0.0) * 100.0));
    return QStringLiteral("%1:%2%3%4")
        .arg(hundredths / 6000)
        .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
        .arg(QLocale().decimalPoint())
        .arg(hundredths % 100, 2, 10, QLatin1Char('0'));
}

} // namespace quadrille::widgets
