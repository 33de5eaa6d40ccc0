// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/matchcosts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace quadrille {

namespace {

constexpr Eigen::Index greatestSide = 512;

/// Of each foot that has contacts, in which frames it stands.
std::map<std::string, std::vector<bool>> standing(const MeshSequence& sequence)
{
    const auto count = static_cast<std::size_t>(sequence.frameCount());
    std::map<std::string, std::vector<bool>> feet;
    for (const ContactSpan& span : sequence.contacts) {
        std::vector<bool>& stands = feet.try_emplace(span.foot, count, false).first->second;
        for (std::int64_t f = std::max<std::int64_t>(span.frames.first.value, 0);
             f <= std::min<std::int64_t>(span.frames.last.value, sequence.frameCount() - 1); ++f)
            stands[static_cast<std::size_t>(f)] = true;
    }
    return feet;
}

void removePosture(double share, Table<float>& costs)
{
    const auto part = static_cast<float>(share);
    const Eigen::ArrayXf rows = costs.rowwise().mean();
    const Eigen::ArrayXf columns = costs.colwise().mean();
    const float mean = costs.mean();
    costs.colwise() -= part * (rows - mean);
    costs.rowwise() -= part * columns.transpose();
    costs -= std::min(costs.minCoeff(), 0.0F);
}

double deviation(const Table<float>& values)
{
    return std::sqrt((values.cast<double>() - static_cast<double>(values.mean())).square().mean());
}

} // namespace

Table<float> matchCosts(const Table<float>& distances, const MeshSequence& reference,
                        const MeshSequence& take, const AlignmentSettings& settings)
{
    Table<float> costs = distances;
    removePosture(settings.postureShare, costs);
    const auto feetOfReference = standing(reference);
    const auto feetOfTake = standing(take);
    std::vector<std::pair<const std::vector<bool>*, const std::vector<bool>*>> feet;
    for (const auto& [name, stands] : feetOfReference) {
        if (const auto other = feetOfTake.find(name); other != feetOfTake.end())
            feet.emplace_back(&stands, &other->second);
    }
    const double whole = settings.contactWeight * deviation(costs);
    for (const auto& [ofReference, ofTake] : feet) {
        const auto cost = static_cast<float>(whole / static_cast<double>(feet.size()));
        for (Eigen::Index r = 0; r < costs.rows(); ++r) {
            for (Eigen::Index c = 0; c < costs.cols(); ++c) {
                if ((*ofReference)[static_cast<std::size_t>(r)] != (*ofTake)[static_cast<std::size_t>(c)])
                    costs(r, c) += cost;
            }
        }
    }
    return costs;
}

void shrink(const Table<float>& costs, WarpReport& report)
{
    const auto perCell = [](Eigen::Index count) { return (count + greatestSide - 1) / greatestSide; };
    const Eigen::Index rows = perCell(costs.rows());
    const Eigen::Index columns = perCell(costs.cols());
    report.rowsPerCell = static_cast<int>(rows);
    report.columnsPerCell = static_cast<int>(columns);
    report.costs.resize((costs.rows() + rows - 1) / rows, (costs.cols() + columns - 1) / columns);
    for (Eigen::Index r = 0; r < report.costs.rows(); ++r) {
        for (Eigen::Index c = 0; c < report.costs.cols(); ++c) {
            report.costs(r, c) = costs
                                     .block(r * rows, c * columns, std::min(rows, costs.rows() - r * rows),
                                            std::min(columns, costs.cols() - c * columns))
                                     .mean();
        }
    }
}

} // namespace quadrille
