// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace quadrille {

/// How a chart is made of a table: bars of some columns for each of its rows, or lines over a column.
struct ChartPlan
{
    const char* evaluation;
    const char* table; ///< data name without "evaluation/"
    const char* title; ///< of context Evaluation
    std::vector<const char*> values;
    /// What names a bar; of lines: what names a series, with the value where there are several.
    std::vector<const char*> categories = {};
    const char* unit = ""; ///< of what is shown, the values times `scale`
    double scale = 1;
    const char* series = "";    ///< bars: the column whose values are series of their own
    const char* over = "";      ///< what values are divided by, a column
    const char* x = "";         ///< lines: along the other axis
    const char* xTitle = "";    ///< of context Evaluation
    bool isLogarithmic = false; ///< along x
};

/// The charts of all evaluations that are made of the columns of their tables.
const std::vector<ChartPlan>& evaluationChartPlans();

} // namespace quadrille
