// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphchartspanel.h"

#include "editor/language/retranslate.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <functional>

namespace quadrille {

namespace {

using widgets::ChartSeries;

std::vector<ChartSeries> seriesOf(const std::vector<GraphComparison>& comparison, const QString& essential,
                                  const QString& motion,
                                  const std::function<double(const GraphStatistics&)>& value)
{
    // The same colours as the sequences' first ones: safe for the colour-blind, and with signs of their own.
    ChartSeries first{essential, widgets::Theme::categorical(0), ChartSeries::Sign::Circle, false, {}};
    ChartSeries second{motion, widgets::Theme::categorical(1), ChartSeries::Sign::Diamond, true, {}};
    for (const GraphComparison& row : comparison) {
        first.points.emplace_back(row.alpha, value(row.essential));
        second.points.emplace_back(row.alpha, value(row.motion));
    }
    return {first, second};
}

} // namespace

GraphChartsPanel::GraphChartsPanel(GraphExplorer& explorer, QWidget* parent)
    : QWidget(parent), m_explorer(explorer), m_compare(new QPushButton)
{
    setObjectName(QStringLiteral("graphChartsPanel"));
    m_compare->setObjectName(QStringLiteral("compareOverAlpha"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(8);
    const std::array<QString, 3> names{QStringLiteral("densityChart"), QStringLiteral("edgesChart"),
                                       QStringLiteral("costChart")};
    for (std::size_t i = 0; i < m_charts.size(); ++i) {
        m_charts[i] = new widgets::LineChart;
        m_charts[i]->setObjectName(names[i]);
        column->addWidget(m_charts[i], 1);
        connect(m_charts[i], &widgets::LineChart::markerMoved, this, &GraphChartsPanel::alphaEdited);
    }
    column->addWidget(m_compare, 0, Qt::AlignHCenter);
    connect(m_compare, &QPushButton::clicked, this, [this] {
        m_explorer.wantComparison();
        refresh();
    });
    connect(&explorer, &GraphExplorer::characterChanged, this, &GraphChartsPanel::refresh);
    connect(&explorer, &GraphExplorer::comparisonChanged, this, &GraphChartsPanel::refresh);
    connect(&explorer, &GraphExplorer::graphsChanged, this, [this] {
        if (!isVisible())
            return;
        m_explorer.askForComparison();
        refresh();
    });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &GraphChartsPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

void GraphChartsPanel::setAlpha(double alpha)
{
    for (widgets::LineChart* chart : m_charts)
        chart->setMarker(alpha, tr("α"));
}

void GraphChartsPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_explorer.askForComparison();
    refresh();
}

void GraphChartsPanel::refresh()
{
    const auto& comparison = m_explorer.comparison();
    const QString essential = tr("Essential graph");
    const QString motion = tr("Motion graph");
    m_charts[0]->setSeries(seriesOf(comparison, essential, motion, [](const GraphStatistics& statistics) {
        return 100 * statistics.density;
    }));
    m_charts[1]->setSeries(seriesOf(comparison, essential, motion, [](const GraphStatistics& statistics) {
        return static_cast<double>(statistics.edges);
    }));
    m_charts[2]->setSeries(seriesOf(comparison, essential, motion, [](const GraphStatistics& statistics) {
        return statistics.pathCosts.mean;
    }));
    const bool waits = m_explorer.graphs() && comparison.empty() && !m_explorer.comparesUnasked();
    m_compare->setVisible(waits);
    const auto [compared, all] = m_explorer.comparedAlphas();
    const QString empty = m_explorer.isComparing()
                              ? tr("Computing the graphs for several α: %1 of %2").arg(compared).arg(all)
                          : waits ? tr("Of so many frames this takes some minutes and much memory.")
                                  : tr("Compute the graph to compare it over α.");
    for (widgets::LineChart* chart : m_charts)
        chart->setEmptyText(empty);
}

void GraphChartsPanel::retranslate()
{
    const widgets::ChartAxis alpha{tr("α"), {}, true};
    m_charts[0]->setAxes(alpha, {tr("Density"), QStringLiteral("%"), false});
    m_charts[1]->setAxes(alpha, {tr("Edges"), {}, false});
    m_charts[2]->setAxes(alpha, {tr("Mean path cost"), {}, false});
    m_compare->setText(tr("Compare over α"));
    refresh();
}

} // namespace quadrille

#include "moc_graphchartspanel.cpp"
