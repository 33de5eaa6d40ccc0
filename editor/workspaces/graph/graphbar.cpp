// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/graph/graphbar.h"

#include "editor/commands/animationedits.h"
#include "editor/context/editorcontext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/graph/graphexplorer.h"
#include "widgets/graph/chartscale.h"
#include "widgets/graph/logslider.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>

namespace quadrille {

namespace {

constexpr int gap = 8;

} // namespace

GraphBar::GraphBar(EditorContext& context, GraphExplorer& explorer, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_explorer(explorer)
    , m_character(new QComboBox)
    , m_alphaLabel(new QLabel)
    , m_alpha(new widgets::LogSlider(leastAlpha, greatestAlpha))
{
    setObjectName(QStringLiteral("graphBar"));
    m_character->setObjectName(QStringLiteral("graphCharacter"));
    m_alpha->setObjectName(QStringLiteral("graphAlpha"));
    m_alphaLabel->setBuddy(m_alpha);
    // Beside the slider, not beside the words below it.
    m_alphaLabel->setContentsMargins(0, 0, 0, m_alphaLabel->fontMetrics().height());
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap, gap / 2, gap, gap / 2);
    row->setSpacing(gap);
    row->addWidget(m_character);
    row->addWidget(m_alphaLabel);
    row->addWidget(m_alpha, 1);
    row->addSpacing(gap);
    row->addWidget(makeTable());
    connect(m_alpha, &widgets::LogSlider::valueEdited, this, &GraphBar::editAlpha);
    connect(m_character, &QComboBox::activated, this, &GraphBar::characterChosen);
    connect(&context.document, &ProjectDocument::changed, this, &GraphBar::followDocument);
    connect(&explorer, &GraphExplorer::characterChanged, this, &GraphBar::showGraphs);
    connect(&explorer, &GraphExplorer::graphsChanged, this, &GraphBar::showGraphs);
    connect(&explorer, &GraphExplorer::pathsChanged, this, &GraphBar::showGraphs);
    connect(&explorer, &GraphExplorer::comparisonChanged, this, &GraphBar::showCurve);
    connect(&explorer, &GraphExplorer::characterChanged, this, &GraphBar::showCurve);
    retranslates(this, [this] { retranslate(); });
    followDocument();
}

QWidget* GraphBar::makeTable()
{
    auto* table = new QWidget;
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(12);
    grid->setVerticalSpacing(0);
    const auto cell = [grid](int row, int column, const QString& name) {
        auto* label = new QLabel;
        label->setObjectName(name);
        label->setFont(widgets::Theme::tabularFont(label->font()));
        label->setTextInteractionFlags(column == 0 ? Qt::NoTextInteraction : Qt::TextSelectableByMouse);
        grid->addWidget(label, row, column, column == 0 ? Qt::AlignLeft : Qt::AlignRight);
        return label;
    };
    for (std::size_t i = 0; i < m_headings.size(); ++i) {
        m_headings[i] = cell(0, static_cast<int>(i) + 1, {});
        m_headings[i]->setForegroundRole(QPalette::PlaceholderText);
    }
    const std::array<QString, 2> names{QStringLiteral("essential"), QStringLiteral("motion")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const int row = static_cast<int>(i) + 1;
        m_rows[i] = {cell(row, 0, names[i] + QStringLiteral("Name")),
                     cell(row, 1, names[i] + QStringLiteral("Edges")),
                     cell(row, 2, names[i] + QStringLiteral("Density")),
                     cell(row, 3, names[i] + QStringLiteral("Cost"))};
    }
    for (int column = 1; column < 4; ++column)
        grid->setColumnMinimumWidth(column, 56);
    return table;
}

QString GraphBar::character() const
{
    return m_character->count() == 0 ? QString() : m_character->currentData().toString();
}

void GraphBar::followDocument()
{
    const QStringList characters = m_context.graphs.characters();
    const QString before = character();
    const QSignalBlocker blocker(m_character);
    m_character->clear();
    for (const QString& name : characters)
        m_character->addItem(name, name);
    m_character->setCurrentIndex(std::max(m_character->findData(before), m_character->count() > 0 ? 0 : -1));
    m_character->setVisible(characters.size() > 1);
    const double alpha = graphEntry(m_context.document.project(), character()).alpha;
    m_alpha->setValue(alpha);
    m_explorer.setAlpha(alpha);
    setEnabled(!characters.isEmpty());
}

void GraphBar::editAlpha(double alpha, bool committed)
{
    GraphEntry entry = graphEntry(m_context.document.project(), character());
    if (entry.character.empty())
        entry.character = character().toStdString();
    entry.alpha = alpha;
    m_explorer.setAlpha(alpha);
    setGraph(m_context.document, tr("Set α to %1").arg(widgets::chartNumber(alpha)), QStringLiteral("alpha"),
             entry, committed ? EditPhase::Final : EditPhase::Dragging);
}

void GraphBar::showGraphs()
{
    const auto& graphs = m_explorer.graphs();
    const auto& measured = m_explorer.measured();
    const bool isMeasured = measured && measured->graphs == graphs;
    const QString none = QStringLiteral("–");
    const QString later = QStringLiteral("…");
    const auto show = [&](const Row& row, const Digraph* graph, bool isWhole, const PathCostSummary* costs) {
        const QString least = isWhole ? QString() : QStringLiteral("≥ ");
        const QString tip = isWhole ? QString() : tr("So many are certain; others are still looked at");
        row.edges->setText(graph ? least + QLocale().toString(static_cast<qlonglong>(graph->edges().size()))
                                 : none);
        row.density->setText(graph ? least + tr("%1 %").arg(widgets::chartNumber(100 * graph->density()))
                                   : none);
        row.edges->setToolTip(tip);
        row.density->setToolTip(tip);
        row.cost->setText(costs ? widgets::chartNumber(costs->mean) : graph ? later : none);
        row.cost->setToolTip(costs ? tr("± %1; %n pair(s) of frames without a way", nullptr,
                                        static_cast<int>(costs->unreachablePairs))
                                         .arg(widgets::chartNumber(costs->standardDeviation))
                                   : QString());
    };
    show(m_rows[0], graphs ? &graphs->essential : nullptr, !graphs || graphs->isWhole,
         isMeasured ? &measured->essential.pathCosts : nullptr);
    show(m_rows[1], graphs ? &graphs->motion : nullptr, true,
         isMeasured ? &measured->motion.pathCosts : nullptr);
}

/// How dense the Essential graph is for each α, as a share of the densest.
void GraphBar::showCurve()
{
    double most = 0;
    for (const GraphComparison& each : m_explorer.comparison())
        most = std::max(most, each.essential.density);
    std::vector<QPointF> curve;
    for (const GraphComparison& each : m_explorer.comparison()) {
        if (most > 0)
            curve.emplace_back(each.alpha, each.essential.density / most);
    }
    m_alpha->setCurve(std::move(curve));
}

void GraphBar::retranslate()
{
    m_character->setAccessibleName(tr("Character"));
    m_character->setToolTip(tr("Whose sequences the graph joins"));
    m_alphaLabel->setText(tr("&α"));
    //: ends of the slider for α: few edges in the graph, many edges in it
    m_alpha->setEnds(tr("sparse: smooth ways"), tr("dense: short ways"));
    const QString tip = tr("Weight of a frame of duration against deformation: higher values prefer short "
                           "ways. The curve is the density of the Essential graph.");
    m_alpha->setToolTip(tip);
    m_alpha->slider()->setAccessibleName(tr("α"));
    m_alpha->slider()->setAccessibleDescription(tip);
    m_alpha->spinBox()->setAccessibleName(tr("α, as a number"));
    m_headings[0]->setText(tr("Edges"));
    m_headings[1]->setText(tr("Density"));
    m_headings[1]->setToolTip(tr("Edges of all that there could be between different frames"));
    m_headings[2]->setText(tr("Mean cost"));
    m_headings[2]->setToolTip(tr("Of the cheapest way from any frame to any other"));
    m_rows[0].name->setText(tr("Essential graph"));
    m_rows[1].name->setText(tr("Motion graph"));
    showGraphs();
}

} // namespace quadrille

#include "moc_graphbar.cpp"
