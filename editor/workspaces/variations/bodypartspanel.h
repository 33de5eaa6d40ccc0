// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvetool.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QStackedLayout;

namespace quadrille {

class BodyPartsTree;

/// Curves and parts of the character's body: tree, what is wrong with them, how they are drawn. The view
/// shows curves and colours while the panel is to be seen.
class BodyPartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BodyPartsPanel(PartCurveTool& tool, QWidget* parent = nullptr);

private:
    QWidget* makeEmptyPage();
    QWidget* makeContent();
    QWidget* makeTools();
    QWidget* makeSettings();
    void connectTool();
    void retranslate();
    void refresh();
    void refreshProblem();
    void refreshOffer();
    void show(const PartNotice& notice);
    using QWidget::show;

    PartCurveTool& m_tool;
    QStackedLayout* m_pages;
    QLabel* m_emptyText;
    QPushButton* m_propose;
    QPushButton* m_draw;
    widgets::MessageStrip* m_emptyNotice;
    widgets::MessageStrip* m_notice;  ///< about the last thing that was asked for
    widgets::MessageStrip* m_problem; ///< of what is selected, or the first
    widgets::MessageStrip* m_offer;
    BodyPartsTree* m_tree;
    QCheckBox* m_snaps;
    QDoubleSpinBox* m_radius;
    QLabel* m_overlapLabel;
    QDoubleSpinBox* m_overlap;
    QLabel* m_poseLabel;
    QLabel* m_pose;
    QPushButton* m_takePose;
};

} // namespace quadrille
