// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/graph/gaps.h"

#include <QWidget>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace quadrille {

class GraphExplorer;

/// Which frames walks do not come to or do not come back from, graph by graph, and what would help: a
/// transition that the graph lacks, or a take that somebody would have to capture.
class GapsPanel : public QWidget
{
    Q_OBJECT

public:
    /// \param explorer  outlives it, as for all panels of the graph.
    explicit GapsPanel(GraphExplorer& explorer, QWidget* parent = nullptr);

signals:
    /// A proposal was clicked: a transition, or the poses that a take would have to join.
    void chosen(const quadrille::FramePair& pair, bool isTransition);

private:
    void refresh();
    void addGraph(const QString& name, const Connectivity& connectivity, const std::vector<GraphGap>& gaps);
    /// Whether it is the start or end of a take, which a transition needs for its window.
    bool isUsual(const GraphGap& gap) const;
    void addGap(QTreeWidgetItem& parent, const GraphGap& gap, const QString& help);
    QString framesOf(const GraphGap& gap) const;
    QString proposalOf(const GraphGap& gap) const;
    void choose(QTreeWidgetItem* item);

    GraphExplorer& m_explorer;
    QLabel* m_summary;
    QTreeWidget* m_tree;
};

} // namespace quadrille
