// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What the map shows of the graphs, and of which takes.
#include "editor/pictures/framepictures.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "editor/workspaces/graph/graphmap.h"
#include "widgets/graph/arcview.h"
#include "widgets/graph/matrixview.h"
#include "widgets/graph/takegraphview.h"
#include "widgets/theme/icons.h"

#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <map>
#include <utility>

namespace quadrille {

namespace {

using widgets::ArcView;
using widgets::MatrixView;
using widgets::TakeGraphView;

constexpr int widestTakeFilter = 180; // pixels

widgets::MatrixMarkRow marksOf(const Digraph& graph)
{
    return [graph](int row, std::vector<widgets::MatrixMark>& marks) {
        if (row >= graph.nodeCount()) // the table is that of another graph by now
            return;
        for (const Edge& edge : graph.edgesFrom(row))
            if (edge.kind == EdgeKind::Transition)
                marks.push_back({edge.from, edge.to, static_cast<float>(edge.weight)});
    };
}

/// Whether an edge is a transition between takes that are looked at.
bool isShown(const Edge& edge, const FrameLayout& layout, const TakeFilter& filter)
{
    return edge.kind == EdgeKind::Transition &&
           filter.passes(layout.sequenceOf(edge.from), layout.sequenceOf(edge.to));
}

std::vector<widgets::TakeLink> linksOf(const Digraph& graph, const FrameLayout& layout)
{
    std::map<std::pair<int, int>, int> counts;
    for (const Edge& edge : graph.edges()) {
        if (edge.kind == EdgeKind::Transition)
            ++counts[{layout.sequenceOf(edge.from), layout.sequenceOf(edge.to)}];
    }
    std::vector<widgets::TakeLink> links;
    links.reserve(counts.size());
    for (const auto& [ends, count] : counts)
        links.push_back({ends.first, ends.second, count});
    return links;
}

std::shared_ptr<const std::vector<widgets::Arc>> arcsOf(const Digraph& graph, const FrameLayout& layout,
                                                        const TakeFilter& filter)
{
    auto arcs = std::make_shared<std::vector<widgets::Arc>>();
    for (const Edge& edge : graph.edges())
        if (isShown(edge, layout, filter))
            arcs->push_back({edge.from, edge.to, static_cast<float>(edge.weight)});
    return arcs;
}

} // namespace

/// Names the takes that are looked at, and brings the others back.
void GraphMap::makeTakeFilter()
{
    m_takeFilter->setObjectName(QStringLiteral("takeFilter"));
    m_takeFilter->setIcon(widgets::icons::icon(QStringLiteral("close")));
    m_takeFilter->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_takeFilter->setLayoutDirection(layoutDirection() == Qt::LeftToRight ? Qt::RightToLeft
                                                                          : Qt::LeftToRight);
    // The map must not become wider when takes are chosen.
    m_takeFilter->setMinimumWidth(1);
    m_takeFilter->hide();
    m_kept->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    connect(m_takeFilter, &QToolButton::clicked, this, &GraphMap::filterDropped);
    connect(m_takes, &TakeGraphView::chosenByUser, this,
            [this](const std::vector<int>& takes) { m_explorer.setFilter({takes}); });
    connect(m_takes, &TakeGraphView::menuRequested, this, &GraphMap::takesMenuRequested);
}

void GraphMap::setMode(Mode mode)
{
    m_filters->setVisible(mode == Mode::Matrix);
    m_pages->setCurrentIndex(static_cast<int>(mode));
    showMode();
}

/// Arcs and counts are made for those who look.
void GraphMap::showMode()
{
    const auto mode = static_cast<Mode>(m_pages->currentIndex());
    if (mode == Mode::Arcs && m_arcsAreOld)
        showArcs();
    if (mode == Mode::Takes && m_takesAreOld)
        showTakes();
}

void GraphMap::setEdgesVisible(bool essential, bool motion)
{
    m_matrix->setMarksVisible(MatrixView::Layer::First, essential);
    m_matrix->setMarksVisible(MatrixView::Layer::Second, motion);
    m_countsMotion = motion && !essential;
    m_takesAreOld = true;
    showMode();
}

void GraphMap::followGraphs()
{
    const auto& graphs = m_explorer.graphs();
    m_matrix->setMarks(MatrixView::Layer::First, tr("Essential graph"),
                       graphs ? marksOf(graphs->essential) : nullptr);
    m_matrix->setMarks(MatrixView::Layer::Second, tr("Motion graph"),
                       graphs ? marksOf(graphs->motion) : nullptr);
    m_arcsAreOld = true;
    m_takesAreOld = true;
    showMode();
}

void GraphMap::showArcs()
{
    const auto& graphs = m_explorer.graphs();
    if (!graphs)
        return;
    const FrameLayout& layout = m_explorer.character()->graph.layout();
    const TakeFilter& filter = m_explorer.filter();
    m_arcs->setArcs(ArcView::Side::Above, tr("Essential graph"), arcsOf(graphs->essential, layout, filter));
    m_arcs->setArcs(ArcView::Side::Below, tr("Motion graph"), arcsOf(graphs->motion, layout, filter));
    m_arcsAreOld = false;
}

void GraphMap::showTakes()
{
    const auto& graphs = m_explorer.graphs();
    if (!graphs || !(graphs->isWhole || m_countsMotion)) // numbers of before are nearer than those of a part
        return;
    m_takes->setLinks(
        m_countsMotion ? tr("Motion graph: transitions between takes")
                       : tr("Essential graph: transitions between takes"),
        linksOf(m_countsMotion ? graphs->motion : graphs->essential, m_explorer.character()->graph.layout()));
    m_takesAreOld = false;
}

void GraphMap::showTakeFilter()
{
    const TakeFilter& filter = m_explorer.filter();
    m_takeFilter->setVisible(!filter.isEmpty());
    m_takes->setChosen(filter.takes);
    if (filter.isEmpty()) {
        m_matrix->setBlockFilter({});
    } else {
        m_matrix->setBlockFilter([filter](int row, int column) { return filter.passes(row, column); });
        QStringList names;
        for (const int take : filter.takes)
            names += m_matrix->blocks()[static_cast<std::size_t>(take)].name;
        const QString text = tr("Only %1").arg(names.join(QStringLiteral(", ")));
        m_takeFilter->setText(m_takeFilter->fontMetrics().elidedText(text, Qt::ElideRight, widestTakeFilter));
        m_takeFilter->setToolTip(tr("%1. Click to look at all takes").arg(text));
        m_takeFilter->setAccessibleName(text);
    }
    m_arcsAreOld = true;
    showMode();
}

void GraphMap::showPictures()
{
    const auto& opened = m_explorer.character();
    if (!opened)
        return;
    std::vector<QImage> pictures;
    pictures.reserve(opened->graph.work().sequences.size());
    for (int s = 0; s < opened->graph.layout().sequenceCount(); ++s)
        pictures.push_back(m_pictures.picture(
            QString::fromStdString(opened->graph.work().sequences[static_cast<std::size_t>(s)]),
            FrameIndex(opened->graph.layout().countOf(s) / 2)));
    m_takes->setPictures(pictures);
    m_matrix->setBlockPictures(std::move(pictures));
}

} // namespace quadrille
