// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/qualitypanel.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/evaluationnames.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/errors/errortext.h"
#include "editor/evaluations/evaluationcharts.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/appearance/componentpictures.h"
#include "widgets/controls/elidedlabel.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace quadrille {

namespace {

constexpr double percentOfVariance = 100;
constexpr int qualityGap = 8;
constexpr int varianceTextures = 0; ///< colours of the lines
constexpr int varianceWarps = 1;

widgets::ChartSeries explainedVariance(const QuantisedSpace& space, const QString& name, int color)
{
    widgets::ChartSeries series{.name = name, .color = widgets::Theme::categorical(color)};
    if (color == varianceWarps)
        series.sign = widgets::ChartSeries::Sign::Diamond;
    double sum = 0;
    int components = 0;
    series.points.emplace_back(0, 0);
    for (const double share : varianceShares(space)) {
        sum += share;
        series.points.emplace_back(++components, percentOfVariance * sum);
    }
    return series;
}

/// What of tables is of a character.
std::vector<DataItem> ofCharacter(const std::vector<DataItem>& tables, const std::string& character)
{
    std::vector<DataItem> own;
    std::ranges::copy_if(tables, std::back_inserter(own), [&](const DataItem& item) {
        return character.empty() || item.character.empty() || item.character == character;
    });
    return own;
}

} // namespace

QualityPanel::QualityPanel(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_what(new QComboBox)
    , m_compute(new QPushButton)
    , m_state(new widgets::ElidedLabel)
    , m_chart(new widgets::LineChart)
{
    setObjectName(QStringLiteral("qualityPanel"));
    m_what->setObjectName(QStringLiteral("qualityWhat"));
    m_compute->setObjectName(QStringLiteral("qualityCompute"));
    m_state->setObjectName(QStringLiteral("qualityState"));
    m_chart->setObjectName(QStringLiteral("qualityChart"));
    m_what->addItem(QString());
    for (const char* table : {"fig17", "fig18"})
        m_what->addItem(QString(), QString::fromLatin1(table));
    auto* tools = new QHBoxLayout;
    tools->setContentsMargins(qualityGap, qualityGap / 2, qualityGap, 0);
    tools->addWidget(m_what);
    tools->addWidget(m_compute);
    tools->addWidget(m_state, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(tools);
    column->addWidget(m_chart, 1);
    connect(m_what, &QComboBox::currentIndexChanged, this, &QualityPanel::refresh);
    connect(m_compute, &QPushButton::clicked, this, &QualityPanel::compute);
    connect(m_chart, &widgets::LineChart::markerMoved, this,
            [this](double components) { m_shown.setUsed(static_cast<int>(std::lround(components))); });
    connect(&shown, &ShownTexture::changed, this, &QualityPanel::refresh);
    connect(&shown.appearance().context().evaluations, &EvaluationResults::changed, this,
            &QualityPanel::refresh);
    connect(&widgets::Theme::instance(), &widgets::Theme::changed, this, &QualityPanel::refresh);
    retranslates(this, [this] { retranslate(); });
}

void QualityPanel::retranslate()
{
    m_what->setItemText(0, tr("Explained variance"));
    for (int i = 1; i < m_what->count(); ++i)
        m_what->setItemText(i, evaluationTitle(m_what->itemData(i).toString()));
    m_what->setAccessibleName(tr("What is drawn over the number of components"));
    m_compute->setText(tr("Compute"));
    m_compute->setToolTip(tr("Adds the evaluation to the project where it is missing, and computes it"));
    m_chart->setEmptyText(tr("What more components give shows here, once the model is built."));
    refresh();
}

QString QualityPanel::evaluation() const
{
    QString table = m_what->currentData().toString();
    if (table.isEmpty())
        return {};
    const std::string character = m_shown.appearance().character().toStdString();
    for (const EvaluationEntry& entry : m_shown.appearance().context().document.project().evaluations) {
        if (entry.table == table.toStdString() && (entry.character.empty() || entry.character == character))
            return evaluationName(entry);
    }
    return table;
}

const EvaluationResults::State* QualityPanel::evaluationState() const
{
    return m_shown.appearance().context().evaluations.resultState(evaluation());
}

void QualityPanel::refresh()
{
    if (evaluation().isEmpty())
        showVariance();
    else
        showEvaluation();
    const bool isUsed = !m_chart->isEmpty() && !evaluation().isEmpty();
    const std::optional<double> used = m_shown.used();
    m_chart->setMarker(isUsed ? used : std::nullopt, tr("used", "components"));
}

void QualityPanel::showVariance()
{
    m_compute->hide();
    m_state->clear();
    m_chart->setAxes({tr("Components of the space"), {}}, {tr("Explained variance"), QStringLiteral("%")});
    std::vector<widgets::ChartSeries> series;
    if (const auto opened = m_shown.appearance().opened()) {
        const AppearanceModel& model = opened->decoder->model();
        series.push_back(explainedVariance(model.textures, tr("Eigen textures"), varianceTextures));
        if (model.warps.count > 0)
            series.push_back(explainedVariance(model.warps, tr("Eigen warps"), varianceWarps));
    }
    m_chart->setSeries(std::move(series));
}

void QualityPanel::showEvaluation()
{
    const EvaluationResults::State* state = evaluationState();
    const bool isComputing = state != nullptr && state->phase == ResultPhase::Computing;
    const bool isReady = state != nullptr && state->phase == ResultPhase::Ready;
    const bool isImpossible = state != nullptr && state->phase == ResultPhase::Impossible;
    m_compute->setVisible(!isReady && !isImpossible);
    m_compute->setEnabled(!isComputing && m_shown.appearance().entry() != nullptr);
    m_state->setText(isComputing                        ? tr("Computing…")
                     : isImpossible                     ? tr("Needs takes of a character.")
                     : state != nullptr && state->error ? describe(*state->error).oneLine()
                                                        : QString());
    m_state->setToolTip(m_state->text());
    const ProjectDocument& document = m_shown.appearance().context().document;
    const auto charts =
        state == nullptr
            ? std::vector<EvaluationChart>()
            : chartsOf(m_what->currentData().toString().toStdString(),
                       ofCharacter(state->tables, m_shown.appearance().character().toStdString()),
                       document.project().settings.axes.up);
    const auto* lines =
        charts.empty() ? nullptr : std::get_if<EvaluationChart::Lines>(&charts.front().content);
    m_chart->setAxes(lines != nullptr ? lines->x : widgets::ChartAxis(),
                     lines != nullptr ? lines->y : widgets::ChartAxis());
    m_chart->setSeries(lines != nullptr ? lines->series : std::vector<widgets::ChartSeries>());
}

void QualityPanel::compute()
{
    EditorContext& context = m_shown.appearance().context();
    QString name = evaluation();
    if (context.document.evaluation(name) == nullptr) {
        EvaluationEntry entry;
        entry.table = m_what->currentData().toString().toStdString();
        if (context.document.project().characters.size() > 1)
            entry.character = m_shown.appearance().character().toStdString();
        name = addEvaluation(context.document, std::move(entry));
    }
    context.evaluations.compute(name);
    refresh();
}

} // namespace quadrille

#include "moc_qualitypanel.cpp"
