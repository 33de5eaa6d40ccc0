// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class CurrentVariation;
struct PartProgress;

namespace widgets {
class LineChart;
} // namespace widgets

/// How far the models of all parts are learned: their objective as it falls, what came out, and the settings
/// of learning and drawing.
class LearningPanel : public QWidget
{
    Q_OBJECT

public:
    explicit LearningPanel(CurrentVariation& variation, QWidget* parent = nullptr);

private:
    void arrangeWidgets();
    void refreshParts();
    void refreshChart();
    void showPart(QTreeWidgetItem& item, const PartProgress& part);

    CurrentVariation& m_variation;
    QLabel* m_state;
    QTreeWidget* m_parts;
    widgets::LineChart* m_chart;
};

} // namespace quadrille
