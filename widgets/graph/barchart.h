// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/chartscale.h"
#include "widgets/graph/linechart.h"

#include <QColor>
#include <QStringList>
#include <QWidget>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// One bar for each category of a chart; every second series is hatched, so that they are told apart by more
/// than colour.
struct BarSeries
{
    QString name;
    QColor color;
    std::vector<std::optional<double>> values; ///< as many as categories; none where nothing was measured
};

/// A chart of bars that lie below each other, with their categories at the left: as high as they need.
/// Keys: ↑ and ↓ (Home, End) go from category to category and read their values out, Ctrl+C copies the values
/// as CSV.
class BarChart : public QWidget
{
    Q_OBJECT

public:
    explicit BarChart(QWidget* parent = nullptr);

    /// \pre Every series has a value, or none, for each category.
    void setBars(const ChartAxis& axis, const QStringList& categories, std::vector<BarSeries> series);
    const QStringList& categories() const { return m_categories; }
    const std::vector<BarSeries>& series() const { return m_series; }
    bool isEmpty() const { return m_categories.isEmpty() || m_series.empty(); }

    /// One row for each category, one column for each series; separated by commas, numbers with points.
    QString csv() const;
    /// "walk: 3.2 %; …" of the category that is read; empty for none.
    QString readOut() const;
    /// Where a bar lies, in this widget's coordinates. \pre It is there.
    QRectF barOf(int category, int series) const;

    QSize sizeHint() const override { return {360, minimumSizeHint().height()}; }
    QSize minimumSizeHint() const override;

public slots:
    /// Onto the clipboard.
    void copyCsv() const;

signals:
    /// The category that is read is another one. It is not told when none is read any more. \param top,
    /// bottom  of it in this widget's coordinates.
    void readingMoved(int top, int bottom);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    double headHeight() const;
    double groupHeight() const;
    double labelWidth() const;
    QRectF groupOf(int category) const;
    ChartScale scale() const;
    void read(int category);
    bool readByKey(const QKeyEvent& event);
    void paintHead(QPainter& painter) const;
    void paintGroup(QPainter& painter, int category) const;

    ChartAxis m_axis;
    QStringList m_categories;
    std::vector<BarSeries> m_series;
    int m_read = -1;
};

} // namespace quadrille::widgets
