// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace quadrille {

class CurrentVariation;

namespace widgets {
class LineChart;
} // namespace widgets

/// How the takes run against the reference: the warp of each as a line, and what was used of it.
class WarpPanel : public QWidget
{
    Q_OBJECT

public:
    explicit WarpPanel(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    void refresh();
    void refreshChart();
    void followPlayer();

    CurrentVariation& m_variation;
    widgets::LineChart* m_chart;
    QTreeWidget* m_takes;
};

} // namespace quadrille
