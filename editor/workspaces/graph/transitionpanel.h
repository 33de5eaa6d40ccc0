// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/framepair.h"

#include <QWidget>
#include <optional>
#include <vector>

class QFormLayout;
class QLabel;

namespace quadrille {

class AlternativesList;
class CostBar;
class FramePictures;
class GraphExplorer;
class TransitionSpeeds;

/// Why a transition is in a graph or not: its cost in parts, its windows, how well it joins, the way that
/// replaces it, and what could be taken instead.
class TransitionPanel : public QWidget
{
    Q_OBJECT

public:
    TransitionPanel(GraphExplorer& explorer, TransitionSpeeds& speeds, FramePictures& pictures,
                    QWidget* parent = nullptr);

    void setFps(double fps);
    void show(const std::optional<FramePair>& pair);
    /// Lists the best transitions from one take to another until one is shown that is not among them.
    /// \return the best one; nothing where there is none.
    std::optional<FramePair> listBest(int from, int to);
    using QWidget::show;
    std::optional<FramePair> shown() const { return m_pair; }

signals:
    /// One of the alternatives was chosen.
    void chosen(const quadrille::FramePair& pair);

private:
    struct Fact
    {
        QLabel* name;
        QLabel* value;
    };
    QLabel* addFact(const char* objectName);
    void refresh();
    void showHeading();
    void showCost();
    void showMembership();
    void showSpeeds();
    QString replacement() const;
    void retranslate();

    GraphExplorer& m_explorer;
    TransitionSpeeds& m_speeds;
    std::optional<FramePair> m_pair;
    double m_fps = 25;
    QLabel* m_title;
    QLabel* m_empty;
    QWidget* m_content;
    QFormLayout* m_form = nullptr;
    std::vector<Fact> m_facts;
    CostBar* m_bar;
    QLabel* m_weight = nullptr;
    QLabel* m_deformation = nullptr;
    QLabel* m_poseCost = nullptr;
    QLabel* m_feetCost = nullptr;
    QLabel* m_speedCost = nullptr;
    QLabel* m_duration = nullptr;
    QLabel* m_length = nullptr;
    QLabel* m_windows = nullptr;
    QLabel* m_slide = nullptr;
    QLabel* m_jump = nullptr;
    QLabel* m_essential = nullptr;
    QLabel* m_motion = nullptr;
    QLabel* m_heading;
    AlternativesList* m_alternatives;
};

} // namespace quadrille
