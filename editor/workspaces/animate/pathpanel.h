// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QStackedLayout;

namespace quadrille {

class ObstacleForm;
class PartList;
class PathForm;
class PathPoints;
class PathTool;
class SpanForm;

/// The path of the animation in numbers: curve, points, spans, obstacles. Every value can be edited.
class PathPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PathPanel(PathTool& tool, QWidget* parent = nullptr);

private:
    QWidget* makeEmptyPage();
    QWidget* makeContent();
    QWidget* makeTools();
    void connectLists();
    void retranslate();
    void refresh();
    void refreshSelection();
    void fillSpans();
    void fillObstacles();

    PathTool& m_tool;
    QStackedLayout* m_pages;
    QLabel* m_emptyText = nullptr;
    QPushButton* m_draw = nullptr;
    PathForm* m_form;
    PathPoints* m_points;
    PartList* m_spans;
    SpanForm* m_span;
    PartList* m_obstacles;
    ObstacleForm* m_obstacle;
    QLabel* m_pointsTitle;
    QLabel* m_spansTitle;
    QLabel* m_obstaclesTitle;
};

} // namespace quadrille
