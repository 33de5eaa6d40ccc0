// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/openanimation.h"

#include <QString>
#include <optional>
#include <vector>

namespace quadrille {

/// One line of what was asked of an animation and what it does.
struct ReportRow
{
    QString what;                   ///< in the user's language
    QString name;                   ///< "key 2", of an action or a span; may be empty
    std::optional<double> wanted;   ///< empty where nothing was asked
    std::optional<double> obtained; ///< empty where there is only text
    QString unit;                   ///< empty for pure numbers
    QString text = {};              ///< in place of a number
    bool isOff = false;             ///< what was wanted is missed by more than half a frame
};

/// All of a result: how long it is, what it costs, whether a better walk may exist, and how keys, path, spans
/// and actions were met. Of an animation that keeps a walk, only the first two. \param fps  of the project.
std::vector<ReportRow> reportOf(const AnimationResult& result, double fps);

/// A point of the chart of the deviation from the path: seconds before post-processing, and metres. Empty
/// without a path.
struct DeviationAt
{
    double seconds = 0;
    double metres = 0;
};
std::vector<DeviationAt> deviationsOf(const AnimationResult& result, double fps);

/// A file of comma-separated values; numbers have points, texts are quoted where they need it. The first row
/// names the columns.
QString reportCsv(const std::vector<ReportRow>& rows);
/// One row for each frame of the clip that is shown: its time, where it comes from, and how far it is from
/// the path while nothing was done to the clip's frames.
QString framesCsv(const AnimationResult& result, double fps);

} // namespace quadrille
