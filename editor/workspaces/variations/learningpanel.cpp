// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/variations/learningpanel.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/actionbutton.h"
#include "editor/fields/rightmenu.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/variations/currentvariation.h"
#include "editor/workspaces/variations/learningsettings.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/theme.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

enum LearningColumn
{
    PartColumn,
    ObjectiveColumn,
    ErrorColumn,
    PcaColumn,
    ColumnCount
};

constexpr double millimetres = 1000;
constexpr int partsHeight = 180; // pixels, as proportions
constexpr int chartHeight = 160;
constexpr int leastChartHeight = 72; // of each on a small screen
constexpr int settingsHeight = 130;

/// Without the tenths of large ones, that leave no room for the names of parts.
QString objectiveText(double objective)
{
    constexpr double large = 1e4;
    return QLocale().toString(objective, 'f', std::abs(objective) < large ? 1 : 0);
}

QString millimetresText(std::optional<double> metres)
{
    return metres ? QLocale().toString(*metres * millimetres, 'f', 2) : QString();
}

/// "α₃", from "alpha3".
QString symbolOf(const std::string& name)
{
    const QString latin = QString::fromStdString(name);
    const QString letter =
        latin.startsWith(QLatin1String("alpha")) ? QStringLiteral("α") : QStringLiteral("β");
    constexpr char16_t subscriptZero = 0x2080;
    return letter + QChar(static_cast<char16_t>(subscriptZero + latin.back().digitValue()));
}

QString stopText(std::optional<GpdmStop> stop)
{
    if (!stop)
        return LearningPanel::tr("being learned");
    switch (*stop) {
    case GpdmStop::Converged:
        return LearningPanel::tr("converged");
    case GpdmStop::Stalled:
        return LearningPanel::tr("as low as it goes");
    case GpdmStop::IterationLimit:
        return LearningPanel::tr("stopped at the limit of iterations");
    case GpdmStop::Cancelled:
        return LearningPanel::tr("stopped by you: the best so far");
    }
    return {};
}

struct NamedValue
{
    const char* name;
    double value;
    const char* unit;
};

std::vector<NamedValue> valuesOf(const GpdmHyperparameters& h)
{
    return {{"alpha1", h.alpha1, " m²"}, {"alpha2", h.alpha2, ""}, {"alpha3", h.alpha3, " m⁻²"},
            {"beta1", h.beta1, ""},      {"beta2", h.beta2, ""},   {"beta3", h.beta3, ""},
            {"beta4", h.beta4, ""}};
}

} // namespace

LearningPanel::LearningPanel(CurrentVariation& variation, QWidget* parent)
    : QWidget(parent)
    , m_variation(variation)
    , m_state(new QLabel)
    , m_parts(new QTreeWidget)
    , m_chart(new widgets::LineChart)
{
    setObjectName(QStringLiteral("learningPanel"));
    arrangeWidgets();
    connect(m_parts, &QTreeWidget::currentItemChanged, this, &LearningPanel::refreshChart);
    connect(&variation, &CurrentVariation::resultChanged, this, [this] {
        refreshParts();
        refreshChart();
    });
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &LearningPanel::refreshChart);
    retranslates(this, [this] {
        m_parts->setHeaderLabels({tr("Part"), tr("Objective"), tr("Error, mm"), tr("PCA, mm")});
        m_parts->headerItem()->setToolTip(
            ErrorColumn, tr("Mean distance of the reconstructed training poses, millimetres"));
        m_parts->headerItem()->setToolTip(PcaColumn, tr("The same with as many principal components"));
        m_parts->setAccessibleName(tr("Parts"));
        m_chart->setAxes({tr("Iteration"), {}}, {tr("Objective"), {}});
        m_chart->setEmptyText(tr("What is minimised shows here while it is learned."));
        refreshParts();
        refreshChart();
    });
}

void LearningPanel::arrangeWidgets()
{
    ActionRegistry& actions = m_variation.context().actions;
    m_state->setObjectName(QStringLiteral("learningState"));
    m_state->setWordWrap(true);
    m_state->setForegroundRole(QPalette::PlaceholderText);
    m_parts->setObjectName(QStringLiteral("learnedParts"));
    addRightMenu(*m_parts);
    m_parts->setColumnCount(ColumnCount);
    m_parts->setUniformRowHeights(true);
    m_parts->setIndentation(12);
    m_parts->setFrameShape(QFrame::NoFrame);
    m_parts->header()->setStretchLastSection(false);
    m_parts->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_parts->header()->setSectionResizeMode(PartColumn, QHeaderView::Stretch);
    m_chart->setObjectName(QStringLiteral("objectiveChart"));
    auto* row = new QHBoxLayout;
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(4);
    for (const char* id : {"variations.learn", "variations.stop"}) {
        QToolButton* button = makeActionButton(actions.action(QLatin1String(id)));
        button->setObjectName(QStringLiteral("panel.") + QLatin1String(id));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        row->addWidget(button);
    }
    row->addStretch(1);
    auto* upper = new QWidget;
    auto* upperColumn = new QVBoxLayout(upper);
    upperColumn->setContentsMargins(0, 0, 0, 0);
    upperColumn->setSpacing(0);
    m_state->setContentsMargins(12, 0, 12, 4);
    upperColumn->addLayout(row);
    upperColumn->addWidget(m_state);
    upperColumn->addWidget(m_parts, 1);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    for (QWidget* part : std::initializer_list<QWidget*>{upper, m_chart, new LearningSettings(m_variation)})
        splitter->addWidget(part);
    for (QWidget* part : std::initializer_list<QWidget*>{m_parts, m_chart})
        part->setMinimumHeight(leastChartHeight);
    // Parts first, then how far they are; settings are seldom touched.
    splitter->setStretchFactor(0, 1);
    splitter->setSizes({partsHeight, chartHeight, settingsHeight});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(splitter);
}

void LearningPanel::showPart(QTreeWidgetItem& item, const PartProgress& part)
{
    item.setText(PartColumn, QString::fromStdString(part.part));
    item.setToolTip(PartColumn, item.text(PartColumn));
    item.setText(ObjectiveColumn, part.objective.empty() ? QString() : objectiveText(part.objective.back()));
    item.setText(ErrorColumn, millimetresText(part.error));
    item.setText(PcaColumn, millimetresText(part.pcaError));
    for (const int column : {ObjectiveColumn, ErrorColumn, PcaColumn}) {
        item.setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        item.setFont(column, widgets::Theme::tabularFont(font()));
    }
    const bool isDone = part.stop == GpdmStop::Converged || part.stop == GpdmStop::Stalled;
    const char* icon = isDone ? "success" : part.stop ? "warning" : "refresh";
    item.setIcon(PartColumn, widgets::icons::icon(QLatin1String(icon)));
    const QString stop = stopText(part.stop);
    item.setToolTip(ObjectiveColumn, stop);
    const auto values = valuesOf(part.state.hyperparameters);
    while (item.childCount() < static_cast<int>(values.size()) + 1)
        item.addChild(new QTreeWidgetItem);
    item.child(0)->setText(
        PartColumn, tr("%n iterations, %1", nullptr, static_cast<int>(part.objective.size())).arg(stop));
    item.child(0)->setFirstColumnSpanned(true);
    for (std::size_t i = 0; i < values.size(); ++i) {
        QTreeWidgetItem* child = item.child(static_cast<int>(i) + 1);
        const bool isAtBound = std::ranges::count(part.activeBounds, std::string(values[i].name)) > 0;
        child->setText(PartColumn, symbolOf(values[i].name));
        child->setText(ObjectiveColumn,
                       QLocale().toString(values[i].value, 'g', 4) + QLatin1String(values[i].unit));
        child->setTextAlignment(ObjectiveColumn, Qt::AlignRight | Qt::AlignVCenter);
        child->setIcon(ObjectiveColumn, isAtBound ? widgets::icons::icon(QStringLiteral("warning"),
                                                                         widgets::ColorRole::WarningText)
                                                  : QIcon());
        child->setToolTip(ObjectiveColumn, isAtBound ? tr("At the bound of what it may be") : QString());
    }
}

void LearningPanel::refreshParts()
{
    const std::vector<PartProgress>& parts = m_variation.parts();
    while (m_parts->topLevelItemCount() > static_cast<int>(parts.size()))
        delete m_parts->takeTopLevelItem(m_parts->topLevelItemCount() - 1);
    while (m_parts->topLevelItemCount() < static_cast<int>(parts.size()))
        new QTreeWidgetItem(m_parts);
    for (std::size_t i = 0; i < parts.size(); ++i)
        showPart(*m_parts->topLevelItem(static_cast<int>(i)), parts[i]);
    m_state->setText(m_variation.stateText());
    m_parts->setVisible(!parts.empty());
}

/// Of the chosen part, or of all.
void LearningPanel::refreshChart()
{
    const std::vector<PartProgress>& parts = m_variation.parts();
    QTreeWidgetItem* chosen = m_parts->currentItem();
    while (chosen != nullptr && chosen->parent() != nullptr)
        chosen = chosen->parent();
    std::vector<widgets::ChartSeries> series;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (chosen != nullptr && chosen != m_parts->topLevelItem(static_cast<int>(i)))
            continue;
        widgets::ChartSeries line{.name = QString::fromStdString(parts[i].part),
                                  .color = widgets::Theme::categorical(static_cast<int>(i))};
        for (std::size_t iteration = 0; iteration < parts[i].objective.size(); ++iteration)
            line.points.emplace_back(static_cast<double>(iteration) + 1, parts[i].objective[iteration]);
        series.push_back(std::move(line));
    }
    m_chart->setSeries(std::move(series));
}

} // namespace quadrille

#include "moc_learningpanel.cpp"
