// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QPointF>
#include <QWidget>
#include <functional>
#include <optional>

namespace quadrille::widgets {

/// A curve of time through points that are edited: across, when something is shown; upwards, which moment of
/// the original it is; both in seconds. Times rise from point to point, moments do not fall. A dashed line is
/// the original's own speed.
///
/// Mouse: drag a point (Escape gives up, Shift lifts the snapping), double click adds one. Keys: Page Up and
/// Page Down choose a point, arrows move it by a frame (with Shift by ten), Insert adds one after it, Delete
/// removes it. The first point stays at time 0; the first and the last cannot be removed.
class CurveEditor : public QWidget
{
    Q_OBJECT

public:
    /// The moment at each time, for given points.
    using Curve = std::function<double(double)>;
    using Interpolation = std::function<Curve(const QList<QPointF>&)>;

    explicit CurveEditor(QWidget* parent = nullptr);

    /// Ignored while a point is dragged. Emits nothing.
    /// \pre two points or more, times rising from 0, moments not falling, in seconds.
    void setPoints(const QList<QPointF>& points);
    const QList<QPointF>& points() const { return m_points; }
    /// How the curve runs between its points; straight until it is set. An empty one makes it straight again.
    void setInterpolation(Interpolation interpolation);
    /// Length of the original, seconds: no moment lies beyond. Points above it are shown, and held below it
    /// as soon as they are moved.
    void setLength(double seconds);
    /// What points snap to and arrows move by: frames a second, > 0.
    void setFps(double fps);
    void setAxisTitles(const QString& time, const QString& moment);

    /// −1 where none is.
    int selected() const { return m_selected; }
    /// Emits nothing; −1, or a point that there is not, for none.
    void select(int point);
    /// Where a time and moment are drawn, in pixels of this widget.
    QPointF positionOf(const QPointF& point) const;
    /// The time and moment at a pixel; they may lie beyond the axes.
    QPointF pointAt(const QPointF& position) const;

    QSize sizeHint() const override { return {280, 220}; }
    QSize minimumSizeHint() const override { return {180, 140}; }

signals:
    /// \param committed false while a point is dragged.
    void edited(const QList<QPointF>& points, bool committed);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    bool isOurKey(int key) const;
    int nearestPoint(const QPointF& position) const;
    double frame() const { return 1 / m_fps; }
    /// Where a point may go: between its neighbours, inside the original.
    QPointF limited(int point, QPointF wanted) const;
    QPointF snapped(const QPointF& point) const;
    /// \return whether it went anywhere.
    bool move(int point, const QPointF& wanted);
    void add(const QPointF& wanted);
    void addAfterSelected();
    void removeSelected();
    void pointsChanged();
    void fit();
    QRectF area() const;
    void paintGrid(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintPoints(QPainter& painter) const;
    void paintReading(QPainter& painter) const;

    QList<QPointF> m_points{{0, 0}, {1, 1}};
    Interpolation m_interpolation;
    Curve m_curve;
    double m_length = 1;
    double m_fps = 30;
    QString m_timeTitle;
    QString m_momentTitle;
    QSizeF m_shown{1, 1}; ///< seconds from the origin to the ends of both axes
    int m_selected = -1;
    int m_hovered = -1;
    std::optional<QList<QPointF>> m_before; ///< the points when dragging began
    QPointF m_grip;                         ///< from the pointer to the point that it took hold of
};

} // namespace quadrille::widgets
