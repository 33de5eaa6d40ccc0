// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

namespace quadrille::widgets {

class TimelineScale;

/// Shows which part of all frames a timeline shows. Dragging the part scrolls, dragging one of its ends zooms
/// about the other one, a double click shows everything. It changes nothing itself.
class TimelineZoomBar : public QWidget
{
    Q_OBJECT

public:
    /// \param scale  outlives the bar.
    explicit TimelineZoomBar(const TimelineScale& scale, QWidget* parent = nullptr);

    static constexpr int thickness = 14;   ///< pixels
    static constexpr int handleWidth = 14; ///< pixels at each end that zoom

    /// The part that is shown, with its handles, which stay wide enough to be hit.
    QRect partRect() const;

signals:
    /// The frames that are to show from now on.
    void partRequested(double first, double frames);
    void fitRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Grip
    {
        None,
        Start,
        Part,
        End
    };
    Grip gripAt(const QPointF& position) const;
    /// Frames for each pixel along which the part can be dragged.
    double framesPerPixel() const;

    const TimelineScale& m_scale;
    Grip m_grip = Grip::None;
    Grip m_hovered = Grip::None;
    double m_pressedAt = 0;
    double m_first = 0; ///< at the press
    double m_frames = 0;
};

} // namespace quadrille::widgets
