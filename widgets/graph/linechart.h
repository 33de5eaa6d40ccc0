// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/chartscale.h"

#include <QColor>
#include <QPointF>
#include <QWidget>
#include <optional>
#include <vector>

namespace quadrille::widgets {

struct ChartAxis
{
    QString title;
    QString unit; ///< empty for pure numbers
    bool isLogarithmic = false;
};

/// A line through points, with a sign at each so that lines are told apart by more than colour.
struct ChartSeries
{
    enum class Sign
    {
        Circle,
        Diamond
    };
    QString name;
    QColor color;
    Sign sign = Sign::Circle;
    bool isDashed = false;
    std::vector<QPointF> points; ///< x ascending; those that a logarithmic axis cannot show are left out
};

/// A chart of several lines with a marker at one value of x that can be dragged.
/// Keys: ← and → (Home, End) go from point to point and read their values out, Return moves the marker there,
/// Ctrl+C copies the values as CSV.
class LineChart : public QWidget
{
    Q_OBJECT

public:
    explicit LineChart(QWidget* parent = nullptr);

    /// The title of y is the chart's accessible name.
    void setAxes(ChartAxis x, ChartAxis y);
    /// The read-out stays where a point still has that x.
    void setSeries(std::vector<ChartSeries> series);
    const std::vector<ChartSeries>& series() const { return m_series; }
    /// A line across the chart. \param name  what stands at it, e.g. "α". \param x  none for no line. Ignored
    /// while it is dragged. Emits nothing.
    void setMarker(std::optional<double> x, const QString& name);
    std::optional<double> marker() const { return m_marker; }
    void setEmptyText(const QString& text);
    bool isEmpty() const;

    /// One row for each x, one column for each series; separated by commas, numbers with points. Cells of
    /// series without a point there are empty. Cost: O(points²) at worst.
    QString csv() const;
    /// What is read out: the x of points, and "α = 0.01; Essential: 3.2; …".
    std::optional<double> readX() const { return m_readX; }
    QString readOut() const;
    /// Where a value shows, in this widget's coordinates. \pre not empty.
    QPointF positionOf(const QPointF& value) const;

    QSize sizeHint() const override { return {360, 220}; }
    QSize minimumSizeHint() const override { return {200, 120}; }

public slots:
    /// Onto the clipboard.
    void copyCsv() const;

signals:
    /// The user moved the marker; committed at the end of a drag.
    void markerMoved(double x, bool committed);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF plotArea() const;
    ChartScale xScale() const;
    ChartScale yScale() const;
    ChartScale yScale(double bottom, double top) const;
    std::vector<QPointF> legendPlaces() const;
    std::vector<double> allX() const;
    bool isOnMarker(const QPointF& position) const;
    void moveMarker(double position, bool committed);
    void read(std::optional<double> x);
    bool readByKey(int key);
    void dataChanged();

    void paintAxes(QPainter& painter) const;
    void paintSeries(QPainter& painter) const;
    void paintMarker(QPainter& painter) const;
    void paintReadOut(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;

    ChartAxis m_x;
    ChartAxis m_y;
    std::vector<ChartSeries> m_series;
    std::optional<double> m_marker;
    QString m_markerName;
    QString m_emptyText;
    std::optional<double> m_readX;
    bool m_isDragging = false;
};

} // namespace quadrille::widgets
