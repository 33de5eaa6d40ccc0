// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/qualitypanel.h"

#include "editor/commands/projectedits.h"
#include "editor/context/editorcontext.h"
#include "editor/documents/evaluationnames.h"
#include "editor/documents/evaluationtexts.h"
#include "editor/errors/errortext.h"
#include "editor/language/retranslate.h"
#include "editor/workspaces/appearance/componentpictures.h"
#include "widgets/graph/linechart.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr double percentOfVariance = 100;
constexpr int qualityGap = 8;
constexpr int varianceTextures = 0; ///< colours of the lines
constexpr int varianceWarps = 1;

/// Tables over the number of components, where this version computes them.
std::vector<std::string> qualityTables()
{
    std::vector<std::string> known;
    for (const char* table : {"fig17", "fig18"}) {
        if (std::ranges::find(evaluationTables, table) != evaluationTables.end())
            known.emplace_back(table);
    }
    return known;
}

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

std::vector<double> numbersOf(const DataArray& column)
{
    return std::visit(
        [](const auto& values) -> std::vector<double> {
            using Values = std::decay_t<decltype(values)>;
            if constexpr (std::is_same_v<Values, std::vector<double>> ||
                          std::is_same_v<Values, std::vector<std::int64_t>>)
                return std::vector<double>(values.begin(), values.end());
            else
                return {};
        },
        column.values);
}

} // namespace

std::vector<widgets::ChartSeries> linesOverComponents(const std::vector<DataItem>& tables,
                                                      const std::string& character)
{
    std::vector<widgets::ChartSeries> lines;
    for (const DataItem& item : tables) {
        const auto* table = std::get_if<DataTable>(&item.content);
        if (table == nullptr ||
            (!character.empty() && !item.character.empty() && item.character != character))
            continue;
        const auto found = std::ranges::find(table->columns, "components", &DataArray::name);
        if (found == table->columns.end())
            continue;
        const std::vector<double> components = numbersOf(*found);
        for (const DataArray& column : table->columns) {
            const std::vector<double> values = numbersOf(column);
            if (column.name == "components" || values.empty() || values.size() != components.size())
                continue;
            const auto number = static_cast<int>(lines.size());
            widgets::ChartSeries line{
                .name = capitalized(evaluationWord(QString::fromStdString(column.name))),
                .color = widgets::Theme::categorical(number),
                .sign = number % 2 == 0 ? widgets::ChartSeries::Sign::Circle
                                        : widgets::ChartSeries::Sign::Diamond,
                .isDashed = QString::fromStdString(column.name).contains(QLatin1String("naive"))};
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (std::isfinite(values[i]))
                    line.points.emplace_back(components[i], values[i]);
            }
            std::ranges::sort(line.points, {}, &QPointF::x);
            lines.push_back(std::move(line));
        }
        break;
    }
    return lines;
}

QualityPanel::QualityPanel(ShownTexture& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_what(new QComboBox)
    , m_compute(new QPushButton)
    , m_state(new QLabel)
    , m_chart(new widgets::LineChart)
{
    setObjectName(QStringLiteral("qualityPanel"));
    m_what->setObjectName(QStringLiteral("qualityWhat"));
    m_compute->setObjectName(QStringLiteral("qualityCompute"));
    m_state->setObjectName(QStringLiteral("qualityState"));
    m_chart->setObjectName(QStringLiteral("qualityChart"));
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_what->addItem({});
    for (const std::string& table : qualityTables())
        m_what->addItem({}, QString::fromStdString(table));
    m_what->setVisible(m_what->count() > 1);
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
    m_compute->setVisible(!isReady);
    m_compute->setEnabled(!isComputing && m_shown.appearance().entry() != nullptr);
    m_state->setText(isComputing                        ? tr("Computing…")
                     : state != nullptr && state->error ? describe(*state->error).oneLine()
                                                        : QString());
    m_state->setToolTip(m_state->text());
    m_chart->setAxes({tr("Components"), {}}, {m_what->currentText(), {}});
    m_chart->setSeries(state == nullptr ? std::vector<widgets::ChartSeries>()
                                        : linesOverComponents(
                                              state->tables, m_shown.appearance().character().toStdString()));
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
