// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace quadrille::widgets {

/// Which frames a strip of pixels shows. Frame f covers [xOf(f), xOf(f + 1)).
class TimelineScale
{
public:
    /// At least one. A scale that shows all frames keeps doing so; so for setWidth().
    void setFrameCount(int frames);
    int frameCount() const { return m_frameCount; }
    void setWidth(double pixels);
    double width() const { return m_width; }

    double xOf(double frame) const { return (frame - m_first) * m_pixelsPerFrame; }
    /// It may lie beyond the frames there are.
    double frameAt(double x) const { return m_first + x / m_pixelsPerFrame; }
    /// The frame that covers a pixel, kept inside the frames there are.
    int nearestFrame(double x) const;
    double pixelsPerFrame() const { return m_pixelsPerFrame; }
    double firstVisible() const { return m_first; }
    double visibleFrames() const { return m_width / m_pixelsPerFrame; }

    /// Shows all frames.
    void fit();
    bool isFitted() const;
    /// Zooms by a factor above one to see more detail; what is at `x` stays there.
    void zoom(double factor, double x);
    /// As far as there are frames to show.
    void scrollTo(double firstFrame);
    /// Shows so many frames from a first one on, as far as there are such and they can be told apart.
    void show(double firstFrame, double frames);
    /// Scrolls as little as needed for a frame to show.
    void reveal(int frame);

    /// Frames between two numbered marks so that these are at least so many pixels apart: 1, 2, 5, 10, …
    int frameStep(double minimumPixels) const;
    /// Seconds between two numbered marks, from a hundredth up to minutes.
    double secondStep(double minimumPixels, double fps) const;

private:
    void limit();

    int m_frameCount = 1;
    double m_width = 1.0;
    double m_first = 0.0;
    double m_pixelsPerFrame = 1.0;
    bool m_fitted = true;
};

/// "0:03.48" for minutes, seconds and hundredths.
QString timeText(double seconds);

} // namespace quadrille::widgets
