// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/graph/transitioncosts.h"

#include "model/core/error.h"

#include <atomic>
#include <cassert>
#include <cmath>
#include <string>
#include <tbb/parallel_for.h>

namespace quadrille {
namespace {

std::string toText(double value)
{
    return std::isnan(value) ? "NaN" : std::to_string(value);
}

Error refusal(const std::string& reason, const std::string& remedy)
{
    return Error(ErrorCode::BadArgument, {.values = {{"reason", reason}, {"remedy", remedy}}});
}

void requireCosts(TableView<float> cost)
{
    std::atomic<bool> isAnyWrong = false;
    tbb::parallel_for(Eigen::Index{0}, cost.rows(), [&](Eigen::Index i) {
        int isWrong = 0;
        for (Eigen::Index j = 0; j < cost.cols(); ++j)
            isWrong |= static_cast<int>(!(cost(i, j) >= 0));
        if (isWrong != 0)
            isAnyWrong = true;
    });
    if (!isAnyWrong)
        return;
    for (Eigen::Index i = 0; i < cost.rows(); ++i) {
        for (Eigen::Index j = 0; j < cost.cols(); ++j) {
            if (!(cost(i, j) >= 0))
                throw refusal("The transition from frame " + std::to_string(i) + " to frame " +
                                  std::to_string(j) + " costs " + toText(cost(i, j)),
                              "Check these frames, then compute the transitions again.");
        }
    }
}

} // namespace

TransitionCosts::TransitionCosts(FrameLayout layout, double largestDistance, Table<float> cost,
                                 SharedTable<std::uint16_t> length)
    : m_cost(std::move(cost))
    , m_length(std::move(length))
    , m_largestDistance(largestDistance)
    , m_layout(std::move(layout))
{
    assert(m_cost.rows() == m_layout.frameCount() && m_cost.cols() == m_layout.frameCount());
    assert(m_length->rows() == m_layout.frameCount() && m_length->cols() == m_layout.frameCount());
    requireCosts(m_cost);
    const bool allAlike = largestDistance == 0 && (m_cost == 0 || m_cost == infinite).all();
    if (!allAlike && !(std::isfinite(largestDistance) && largestDistance > 0))
        throw refusal("The largest pose distance cannot be " + toText(largestDistance),
                      "It must be above 0, unless all transitions cost nothing.");
    if (allAlike)
        m_largestDistance = 1;
    assert((m_cost == infinite || *m_length >= std::uint16_t{1}).all());
}

Table<double> completeWeights(const TransitionCosts& costs, double alpha)
{
    requireAlpha(alpha);
    const NodeIndex frames = costs.layout().frameCount();
    Table<double> weights(frames, frames);
    tbb::parallel_for(NodeIndex{0}, frames,
                      [&](NodeIndex i) { completeWeightsFrom(costs, i, alpha, &weights(i, 0)); });
    return weights;
}

void completeWeightsFrom(const TransitionCosts& costs, NodeIndex from, double alpha, double* row)
{
    const FrameLayout& layout = costs.layout();
    for (NodeIndex j = 0; j < layout.frameCount(); ++j)
        row[j] = costs.weight(from, j, alpha);
    row[from] = unreachable;
    const NodeIndex last = layout.lastOf(layout.sequenceOf(from));
    if (from < last)
        row[from + 1] = alpha;
    for (NodeIndex j = from + 2; j <= last; ++j)
        if (row[j] > alpha * (j - from))
            row[j] = unreachable;
}

void requireAlpha(double alpha)
{
    if (!(std::isfinite(alpha) && alpha >= 0))
        throw refusal("alpha cannot be " + toText(alpha), "It must be 0 or more.");
}

} // namespace quadrille
