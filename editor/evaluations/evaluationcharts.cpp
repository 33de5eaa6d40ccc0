// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/evaluations/evaluationcharts.h"

#include "editor/documents/evaluationtexts.h"
#include "editor/evaluations/evaluationchartplans.h"
#include "model/project/store/dataitem.h"
#include "widgets/theme/theme.h"

#include <QCoreApplication>
#include <QHash>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace quadrille {

namespace {

QString translatedTitle(const char* text)
{
    return QCoreApplication::translate("Evaluation", text);
}

/// The unit of a chart; "frames" is a word.
QString unitOfChart(const QString& unit)
{
    return unit == QLatin1String("frames") || unit == QLatin1String("frame")
               ? QCoreApplication::translate("Evaluation", "frames")
               : unit;
}

const DataArray* columnNamed(const DataTable& table, const std::string& name)
{
    const auto found = std::ranges::find(table.columns, name, &DataArray::name);
    return found == table.columns.end() ? nullptr : &*found;
}

std::size_t rowsOf(const DataTable& table)
{
    return table.columns.empty() ? 0 : valueCount(table.columns.front().values);
}

double numberIn(const DataArray& column, std::size_t row)
{
    return std::visit(
        [row](const auto& values) -> double {
            if constexpr (std::is_same_v<std::decay_t<decltype(values)>, TextColumn>)
                return std::numeric_limits<double>::quiet_NaN();
            else
                return static_cast<double>(values[row]);
        },
        column.values);
}

bool isText(const DataArray& column)
{
    return std::holds_alternative<TextColumn>(column.values);
}

QString textIn(const DataArray& column, std::size_t row)
{
    return evaluationWord(QString::fromStdString(std::get<TextColumn>(column.values)[row]));
}

bool isSameEverywhere(const DataArray& column)
{
    for (std::size_t row = 1; row < valueCount(column.values); ++row)
        if (numberIn(column, row) != numberIn(column, 0))
            return false;
    return true;
}

/// One table, of one character.
class Rows
{
public:
    Rows(const DataItem& item, const ChartPlan& plan, bool namesCharacter)
        : m_item(item)
        , m_table(std::get<DataTable>(item.content))
        , m_plan(plan)
        , m_namesCharacter(namesCharacter)
    {
    }

    std::size_t count() const { return rowsOf(m_table); }
    const DataArray* column(const char* name) const { return columnNamed(m_table, name); }

    std::optional<double> value(const char* name, std::size_t row) const
    {
        const DataArray* values = column(name);
        if (values == nullptr)
            return std::nullopt;
        double number = numberIn(*values, row) * m_plan.scale;
        if (*m_plan.over != '\0')
            number /= numberIn(*column(m_plan.over), row);
        return std::isfinite(number) ? std::optional(number) : std::nullopt;
    }

    /// "anna · walk · weight 0.3": texts as they are, numbers by what they are, without those that say
    /// nothing.
    QString name(std::size_t row) const
    {
        QStringList parts;
        if (m_namesCharacter)
            parts += QString::fromStdString(m_item.character);
        for (const char* each : m_plan.categories) {
            const DataArray* column = columnNamed(m_table, each);
            if (column == nullptr)
                continue;
            if (isText(*column)) {
                if (const QString text = textIn(*column, row); !text.isEmpty())
                    parts += text;
                continue;
            }
            const double number = numberIn(*column, row);
            if (std::isnan(number) || number == 0 || isSameEverywhere(*column))
                continue;
            const QString word = evaluationWord(QLatin1String(each));
            if (!parts.isEmpty() && parts.back() == word)
                parts.removeLast();
            //: a word and its value: "slope 2"
            parts +=
                QCoreApplication::translate("Evaluation", "%1 %2").arg(word, widgets::chartNumber(number));
        }
        return parts.join(QStringLiteral(" · "));
    }

private:
    const DataItem& m_item;
    const DataTable& m_table;
    const ChartPlan& m_plan;
    bool m_namesCharacter;
};

EvaluationChart barsOf(const ChartPlan& plan, const std::vector<Rows>& tables)
{
    EvaluationChart::Bars bars;
    bars.axis = {translatedTitle(plan.title), unitOfChart(QLatin1String(plan.unit)), false};
    const auto seriesOf = [&](const QString& name) -> widgets::BarSeries& {
        const auto found = std::ranges::find(bars.series, name, &widgets::BarSeries::name);
        if (found != bars.series.end())
            return *found;
        const auto color = widgets::Theme::categorical(static_cast<int>(bars.series.size()));
        bars.series.push_back({name, color, {}});
        return bars.series.back();
    };
    for (const Rows& rows : tables) {
        for (std::size_t row = 0; row < rows.count(); ++row) {
            const QString category = rows.name(row);
            auto place = bars.categories.indexOf(category);
            const bool isGrouped = *plan.series != '\0';
            if (place < 0 || !isGrouped) {
                place = bars.categories.size();
                bars.categories += category;
            }
            for (const char* value : plan.values) {
                const DataArray* series = isGrouped ? rows.column(plan.series) : nullptr;
                widgets::BarSeries& own =
                    seriesOf(series != nullptr ? textIn(*series, row) : evaluationWord(QLatin1String(value)));
                own.values.resize(static_cast<std::size_t>(bars.categories.size()));
                own.values[static_cast<std::size_t>(place)] = rows.value(value, row);
            }
        }
    }
    for (widgets::BarSeries& series : bars.series)
        series.values.resize(static_cast<std::size_t>(bars.categories.size()));
    return {bars.axis.title, std::move(bars)};
}

/// The series of a chart of lines, told apart by sign and dashes as well.
widgets::ChartSeries& lineNamed(std::vector<widgets::ChartSeries>& series, const QString& name)
{
    const auto found = std::ranges::find(series, name, &widgets::ChartSeries::name);
    if (found != series.end())
        return *found;
    const auto index = series.size();
    using Sign = widgets::ChartSeries::Sign;
    series.push_back({.name = name,
                      .color = widgets::Theme::categorical(static_cast<int>(index)),
                      .sign = index % 2 == 0 ? Sign::Circle : Sign::Diamond,
                      .isDashed = index % 4 == 1 || index % 4 == 2});
    return series.back();
}

/// What a line is called: by its rows, and by its column where there are several.
QString lineName(const ChartPlan& plan, const char* value, const QString& rows)
{
    if (plan.values.size() < 2)
        return rows;
    const QString word = evaluationWord(QLatin1String(value));
    return rows.isEmpty() ? word : rows + QStringLiteral(" · ") + word;
}

EvaluationChart linesOf(const ChartPlan& plan, const std::vector<Rows>& tables)
{
    EvaluationChart::Lines lines;
    lines.x = {translatedTitle(plan.xTitle), {}, plan.isLogarithmic};
    lines.y = {translatedTitle(plan.title), unitOfChart(QLatin1String(plan.unit)), false};
    for (const Rows& rows : tables) {
        for (const char* each : plan.values)
            for (std::size_t row = 0; row < rows.count(); ++row)
                if (const auto value = rows.value(each, row))
                    lineNamed(lines.series, lineName(plan, each, rows.name(row)))
                        .points.emplace_back(numberIn(*rows.column(plan.x), row), *value);
    }
    return {lines.y.title, std::move(lines)};
}

/// The way of the body's centre as seen from above.
std::optional<EvaluationChart> wayOf(const DataItem& item, UpAxis up, bool namesCharacter)
{
    const auto& table = std::get<DataTable>(item.content);
    const auto axisName = [](int axis) { return std::string(1, static_cast<char>('x' + axis)); };
    const int upwards = static_cast<int>(up);
    const int first = upwards == 0 ? 1 : 0;
    const DataArray* x = columnNamed(table, axisName(first));
    const DataArray* y = columnNamed(table, axisName(3 - upwards - first));
    const DataArray* variant = columnNamed(table, "variant");
    if (x == nullptr || y == nullptr || variant == nullptr)
        return std::nullopt;
    EvaluationChart::Lines lines;
    const QString unit = QString::fromStdString(x->unit);
    lines.x = {QString::fromStdString(x->name), unit, false};
    lines.y = {translatedTitle(QT_TRANSLATE_NOOP("Evaluation", "Way of the centre, seen from above")), unit,
               false};
    for (std::size_t row = 0; row < rowsOf(table); ++row) {
        QString name = textIn(*variant, row);
        if (namesCharacter)
            name = QString::fromStdString(item.character) + QStringLiteral(" · ") + name;
        lineNamed(lines.series, name).points.emplace_back(numberIn(*x, row), numberIn(*y, row));
    }
    return EvaluationChart{lines.y.title, std::move(lines)};
}

} // namespace

std::vector<EvaluationChart> chartsOf(const std::string& table, const std::vector<DataItem>& tables,
                                      UpAxis up)
{
    const auto isNamed = [](const DataItem& item, const std::string& name) {
        return item.name == "evaluation/" + name;
    };
    const auto isOfAnother = [&](const DataItem& item) { return item.character != tables.front().character; };
    const bool namesCharacter = !tables.empty() && std::ranges::any_of(tables, isOfAnother);
    std::vector<EvaluationChart> charts;
    for (const ChartPlan& plan : evaluationChartPlans()) {
        if (table != plan.evaluation)
            continue;
        std::vector<Rows> rows;
        for (const DataItem& item : tables)
            if (isNamed(item, plan.table))
                rows.emplace_back(item, plan, namesCharacter);
        if (!rows.empty())
            charts.push_back(*plan.x != '\0' ? linesOf(plan, rows) : barsOf(plan, rows));
    }
    for (const DataItem& item : tables) {
        if (table != "fig11" && table != "fig12")
            break;
        if (auto way = isNamed(item, table) ? wayOf(item, up, namesCharacter) : std::nullopt)
            charts.push_back(std::move(*way));
    }
    return charts;
}

QString evaluationNumber(double value)
{
    constexpr int digits = 4;
    return std::isfinite(value) ? widgets::chartNumber(value, digits) : QStringLiteral("–");
}

} // namespace quadrille
