// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/appearanceposes.h"

#include "model/project/document/lengthunit.h"
#include "model/project/steps/charactersteps.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::int64_t mostPoses = 400;

std::vector<AppearanceRow> spreadRows(const std::vector<AppearanceRow>& rows)
{
    const std::int64_t count = std::min<std::int64_t>(std::ssize(rows), mostPoses);
    std::vector<AppearanceRow> spread;
    for (std::int64_t i = 0; i < count; ++i)
        spread.push_back(rows[static_cast<std::size_t>(i * std::ssize(rows) / count)]);
    return spread;
}

/// Coefficients as a result has them, of the rows of poses.
Eigen::MatrixXd coefficientsAt(const Result& model, const char* name, const std::vector<AppearanceRow>& rows)
{
    const DataArray& array = arrayOf(model, name);
    const auto& values = std::get<std::vector<double>>(array.values);
    Eigen::MatrixXd all(std::ssize(rows), array.shape[1]);
    for (Eigen::Index row = 0; row < all.rows(); ++row) {
        const std::int64_t first = rows[static_cast<std::size_t>(row)].row * array.shape[1];
        for (Eigen::Index c = 0; c < all.cols(); ++c)
            all(row, c) = values[static_cast<std::size_t>(first + c)];
    }
    return all;
}

Result learnedPoses(const AppearanceWork& work, const Result& model, const Progress& progress)
{
    constexpr double reading = 0.3;
    constexpr double comparing = 0.4;
    const KnownPoses known = knownPoses(*work.opener, appearanceRows(model), progress.part(0, reading));
    const Eigen::MatrixXd distances = squaredDistances(known.places, progress.part(reading, comparing));
    LearnedPoses learned{.places = known.places};
    for (const AppearanceRow& row : known.rows)
        learned.frames.emplace_back(row.sequence, row.frame);
    const auto found = [&](const char* name, double from, double to) {
        return foundScale(distances, coefficientsAt(model, name, known.rows), known.takes,
                          progress.part(from, to));
    };
    const double half = (1 + comparing) / 2;
    learned.scales = {found("coefficients", comparing, half), found("warp-coefficients", half, 1)};
    return posesResult(learned, unitText(work.opener->project().settings.axes.metresPerUnit));
}

} // namespace

KnownPoses knownPoses(SequenceOpener& opener, const std::vector<AppearanceRow>& rows,
                      const Progress& progress)
{
    KnownPoses known{.rows = spreadRows(rows)};
    for (const AppearanceRow& row : known.rows) {
        if (known.names.empty() || known.names.back() != row.sequence)
            known.names.push_back(row.sequence);
        known.takes.push_back(std::ssize(known.names) - 1);
    }
    const auto pose = [&](std::int64_t place) {
        const AppearanceRow& row = known.rows[static_cast<std::size_t>(place)];
        return opener.open(row.sequence)->sequence.frame(row.frame);
    };
    const auto vertices = opener.open(rows.front().sequence)->sequence.topology->vertexCount();
    known.places = posePlaces(std::ssize(known.rows), vertices, pose, progress);
    return known;
}

BuildStep posesStep(const std::shared_ptr<const AppearanceWork>& work)
{
    // The model depends on all files and settings of the sequences, so their poses are those that it was of.
    const std::string model = appearanceModelStep(work->entry.name);
    BuildStep step = work->step(appearancePosesStep(work->entry.name));
    step.inputs = {model};
    step.compute = [work, model](const StepContext& context, const Progress& progress) {
        return learnedPoses(*work, *context.resultOf(model), progress);
    };
    return step;
}

} // namespace quadrille
