// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transition/framepair.h"

#include <QTreeWidget>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille {

class FramePictures;
class GraphExplorer;
class TransitionSpeeds;

/// Transitions that could be taken instead of one, or between two takes, with pictures of both frames, what
/// they cost and how well they join.
class AlternativesList : public QTreeWidget
{
    Q_OBJECT

public:
    AlternativesList(GraphExplorer& explorer, TransitionSpeeds& speeds, FramePictures& pictures,
                     QWidget* parent = nullptr);

    /// Shows those of a transition; none without one. At most ten are listed, only those of takes that are
    /// looked at; their speeds are asked for.
    void show(const std::optional<FramePair>& pair);
    /// Shows the best from one take to another, until a transition is shown that is not among them. \param
    /// from, to  takes, by their places in the character's layout.
    void showBest(int from, int to);
    /// The takes of showBest, while these are shown.
    const std::optional<std::pair<int, int>>& ends() const { return m_ends; }
    using QTreeWidget::show;
    /// Those that are listed, the cheapest first.
    const std::vector<FramePair>& listed() const { return m_listed; }

signals:
    /// By a click or Return; not what is shown already.
    void chosen(const quadrille::FramePair& pair);

private:
    enum Column
    {
        Both,
        Weight,
        Slide,
        Jump,
        Frames,
        ColumnCount,
    };
    void refresh();
    void showPictures();
    void showSpeeds();
    void choose(QTreeWidgetItem* item);
    void retranslate();

    GraphExplorer& m_explorer;
    TransitionSpeeds& m_speeds;
    FramePictures& m_pictures;
    std::vector<FramePair> sought() const;

    std::optional<FramePair> m_pair;
    std::optional<std::pair<int, int>> m_ends;
    std::vector<FramePair> m_listed;
};

/// "0.12" for metres a second; "–" where there is nothing to measure, "…" where it is not measured yet.
QString speedText(bool isMeasured, const std::optional<double>& speed);

} // namespace quadrille
