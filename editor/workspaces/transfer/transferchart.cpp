// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/transfer/transferchart.h"

#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/transfer/currenttransfer.h"
#include "editor/workspaces/view/sceneview.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

namespace quadrille {

namespace {

constexpr int chartGap = 8; // pixels
/// Columns of the report, in the order of the choice, and what they are multiplied with.
struct ReportColumn
{
    const char* name;
    double scale;
};
constexpr std::array<ReportColumn, 5> reportColumns{
    {{"volume", 100}, {"mark-error", 1}, {"skate", 100}, {"limb-error", 1}, {"foot-error", 1}}};

} // namespace

TransferChart::TransferChart(CurrentTransfer& transfer, QWidget* parent)
    : QWidget(parent), m_transfer(transfer), m_what(new QComboBox), m_chart(new widgets::LineChart)
{
    setObjectName(QStringLiteral("transferChart"));
    m_what->setObjectName(QStringLiteral("transferChartWhat"));
    m_chart->setObjectName(QStringLiteral("transferChartLines"));
    for (std::size_t i = 0; i < reportColumns.size(); ++i)
        m_what->addItem(QString());
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(chartGap, chartGap / 2, chartGap, 0);
    tools->addWidget(m_what);
    tools->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(tools);
    column->addWidget(m_chart, 1);
    connect(m_what, &QComboBox::currentIndexChanged, this, &TransferChart::refresh);
    connect(m_chart, &widgets::LineChart::markerMoved, this, [this](double frame) {
        m_transfer.view().player().pause();
        m_transfer.view().player().goTo(std::lround(frame));
    });
    connect(&transfer, &CurrentTransfer::resultChanged, this, &TransferChart::refresh);
    connect(&transfer.view().player(), &Player::frameChanged, this, &TransferChart::showFrame);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &TransferChart::refresh);
    retranslates(this, [this] { retranslate(); });
}

void TransferChart::retranslate()
{
    m_what->setItemText(0, tr("Volume"));
    m_what->setItemText(1, tr("Error of paired triangles"));
    m_what->setItemText(2, tr("Feet that slide"));
    m_what->setItemData(0, tr("Of the body, against its volume at rest"), Qt::ToolTipRole);
    m_what->setItemData(1, tr("The mean angle by which paired triangles miss the template’s rotation"),
                        Qt::ToolTipRole);
    m_what->setItemData(2, tr("How fast feet that stand until the next frame move"), Qt::ToolTipRole);
    m_what->setItemText(3, tr("Directions of limbs"));
    m_what->setItemText(4, tr("Directions of feet"));
    m_what->setItemData(3,
                        tr("The mean angle by which lower arms and legs point elsewhere than the template’s"),
                        Qt::ToolTipRole);
    m_what->setItemData(4, tr("The mean angle by which feet point elsewhere than the template’s"),
                        Qt::ToolTipRole);
    m_what->setAccessibleName(tr("What is drawn over the frames"));
    m_chart->setEmptyText(tr("How each frame came out shows here, once the clip is computed."));
    refresh();
}

void TransferChart::refresh()
{
    const auto what = static_cast<std::size_t>(std::max(m_what->currentIndex(), 0));
    const std::array<QString, reportColumns.size()> units{QStringLiteral("%"), tr("°"), tr("cm/s"), tr("°"),
                                                          tr("°")};
    m_chart->setAxes({tr("Frame"), {}}, {m_what->currentText(), units[what]});
    std::vector<widgets::ChartSeries> series;
    if (const TransferResultPointer result = m_transfer.result()) {
        widgets::ChartSeries line{.name = m_what->currentText(),
                                  .color = widgets::Theme::categorical(static_cast<int>(what))};
        const auto& values = columnNamed<std::vector<double>>(result->report, reportColumns[what].name);
        for (std::size_t f = 0; f < values.size(); ++f) {
            if (std::isfinite(values[f]))
                line.points.emplace_back(static_cast<double>(f), reportColumns[what].scale * values[f]);
        }
        if (!line.points.empty())
            series.push_back(std::move(line));
    }
    m_chart->setSeries(std::move(series));
    showFrame();
}

void TransferChart::showFrame()
{
    const std::optional<double> frame =
        m_chart->isEmpty() ? std::nullopt
                           : std::optional(static_cast<double>(m_transfer.view().player().frame().value));
    m_chart->setMarker(frame, tr("frame"));
}

} // namespace quadrille

#include "moc_transferchart.cpp"
