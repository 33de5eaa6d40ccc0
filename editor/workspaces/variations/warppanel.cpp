// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/warppanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/takeuse.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/variation/movement.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QHeaderView>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace quadrille {

namespace {

/// As in the latent view.
constexpr int firstWarpColor = 7;
constexpr double percentOfAll = 100; // percent
constexpr double degrees = 57.29577951308232;

/// Where in the frames that are used of a take each reference frame lies.
std::vector<QPointF> lineOf(const TakeWarp& warp)
{
    std::vector<QPointF> points;
    const auto first = static_cast<double>(warp.frames.first.value);
    const auto length = static_cast<double>(std::max<std::int64_t>(warp.frames.count() - 1, 1));
    for (std::size_t frame = 0; frame < warp.positions.size(); ++frame)
        points.emplace_back(static_cast<double>(frame),
                            percentOfAll * (warp.positions[frame] - first) / length);
    return points;
}

} // namespace

WarpPanel::WarpPanel(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent), m_variation(variation), m_chart(new widgets::LineChart), m_takes(new QTreeWidget)
{
    setObjectName(QStringLiteral("warpPanel"));
    m_chart->setObjectName(QStringLiteral("warpChart"));
    m_takes->setObjectName(QStringLiteral("warpedTakes"));
    addRightMenu(*m_takes);
    m_takes->setRootIsDecorated(false);
    m_takes->setUniformRowHeights(true);
    m_takes->setFrameShape(QFrame::NoFrame);
    m_takes->setColumnCount(3);
    m_takes->header()->setStretchLastSection(false);
    m_takes->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_takes->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_chart, 1);
    column->addWidget(m_takes);
    connect(&variation, &CurrentVariation::resultChanged, this, &WarpPanel::refresh);
    connect(&variation.view().player(), &Player::frameChanged, this, &WarpPanel::followPlayer);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &WarpPanel::refreshChart);
    connect(m_chart, &widgets::LineChart::markerMoved, this,
            [this](double frame) { m_variation.goToReference(frame); });
    connect(m_takes, &QTreeWidget::itemSelectionChanged, this, &WarpPanel::refreshChart);
    retranslates(this, [this] {
        m_chart->setAxes({tr("Reference frame"), {}}, {tr("Take"), QStringLiteral("%")});
        m_chart->setEmptyText(tr("How the takes are warped onto the reference shows here, once some are "
                                 "checked in the panel Movement."));
        m_takes->setHeaderLabels({tr("Take"), tr("Used"), tr("Mean cost")});
        m_takes->headerItem()->setToolTip(
            2, tr("How far apart poses are that are matched, degrees per triangle"));
        m_takes->setAccessibleName(tr("Warped takes"));
        refresh();
    });
}

void WarpPanel::refresh()
{
    const auto movement = m_variation.movement();
    m_takes->clear();
    m_takes->setVisible(movement != nullptr);
    for (std::size_t i = 0; movement != nullptr && i < movement->capturedCount(); ++i) {
        const AlignedTake& take = movement->take(i);
        const WarpReport& report = movement->alignment.reports[i];
        auto* item = new QTreeWidgetItem(m_takes);
        item->setText(0, QString::fromStdString(take.name));
        item->setText(1, usedText(take.warp.frames));
        item->setText(2, tr("%1°", "an angle").arg(QLocale().toString(report.meanCost * degrees, 'f', 1)));
        for (int column = 0; column < 3; ++column)
            item->setToolTip(column, useText(report.use));
        for (const int number : {1, 2}) {
            item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
            item->setFont(number, widgets::Theme::tabularFont(font()));
        }
    }
    // The chart gets what the table does not need.
    constexpr int mostRows = 5;
    const int rows = std::clamp(m_takes->topLevelItemCount(), 1, mostRows);
    m_takes->setFixedHeight(m_takes->header()->sizeHint().height() +
                            rows * std::max(m_takes->sizeHintForRow(0), 16) + 2);
    refreshChart();
}

/// Of the selected takes, or of all.
void WarpPanel::refreshChart()
{
    const auto movement = m_variation.movement();
    const bool isChoice = !m_takes->selectedItems().isEmpty();
    std::vector<widgets::ChartSeries> series;
    for (std::size_t i = 0; movement != nullptr && i < movement->capturedCount(); ++i) {
        if (isChoice && !m_takes->topLevelItem(static_cast<int>(i))->isSelected())
            continue;
        series.push_back(
            {.name = QString::fromStdString(movement->take(i).name),
             .color = widgets::Theme::categorical(firstWarpColor + static_cast<int>(i)),
             .sign = i % 2 == 0 ? widgets::ChartSeries::Sign::Circle : widgets::ChartSeries::Sign::Diamond,
             .isDashed = i == movement->alignment.reference,
             .points = lineOf(movement->take(i).warp)});
    }
    m_chart->setSeries(std::move(series));
    followPlayer();
}

void WarpPanel::followPlayer()
{
    const auto frame = m_variation.referenceFrame();
    m_chart->setMarker(frame ? std::optional(*frame) : std::nullopt,
                       tr("now", "time of the frame that is shown"));
}

} // namespace quadrille

#include "moc_warppanel.cpp"
