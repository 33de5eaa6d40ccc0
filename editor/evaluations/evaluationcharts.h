// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/dataitem.h"
#include "model/sequence/axes.h"
#include "widgets/graph/barchart.h"

#include <QString>
#include <variant>
#include <vector>

namespace quadrille {

/// One picture of what an evaluation measured.
struct EvaluationChart
{
    struct Bars
    {
        widgets::ChartAxis axis;
        QStringList categories;
        std::vector<widgets::BarSeries> series;
    };
    struct Lines
    {
        widgets::ChartAxis x;
        widgets::ChartAxis y;
        std::vector<widgets::ChartSeries> series;
    };
    QString title;
    std::variant<Bars, Lines> content;
};

/// The charts that make sense of an evaluation's tables, the most telling one first. None where there is no
/// plan for any.
/// \param table  one of evaluationTables. \param up  of the project: ways are shown as seen from above.
std::vector<EvaluationChart> chartsOf(const std::string& table, const std::vector<DataItem>& tables,
                                      UpAxis up);

/// A number of a table as users read it; "–" where nothing was measured.
QString evaluationNumber(double value);

} // namespace quadrille
