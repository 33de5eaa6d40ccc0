// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/blenderrors.h"

#include "model/core/badargument.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace quadrille {

namespace {

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

RowMatrix between(const LearnedBlend& a, const LearnedBlend& b, double weight)
{
    const double share = (weight - a.weight) / (b.weight - a.weight);
    return (1 - share) * a.latents + share * b.latents;
}

std::vector<double> errorsOf(const PoseReconstruction& reconstruction, const RowMatrix& trajectory,
                             const AlignedTake& truth, const BodyPart& part)
{
    const RowMatrix poses = reconstruction.means(trajectory);
    std::vector<double> errors;
    for (std::size_t f = 0; f < truth.placements.size(); ++f) {
        const Positions pose = truth.pose(f);
        double sum = 0;
        for (std::size_t v = 0; v < part.vertices.size(); ++v) {
            const Eigen::RowVector3d found =
                poses.row(static_cast<Eigen::Index>(f)).segment<3>(static_cast<Eigen::Index>(3 * v));
            sum += (found.transpose() - pose[part.vertices[v].value].cast<double>()).norm();
        }
        errors.push_back(sum / static_cast<double>(part.vertices.size()));
    }
    return errors;
}

} // namespace

double BlendErrors::meanFromTakes() const
{
    return mean(fromTakes);
}

double BlendErrors::meanFromNearby() const
{
    return mean(fromNearby);
}

BlendErrors blendErrors(const PoseReconstruction& reconstruction, std::span<const LearnedBlend> learned,
                        double weight, const AlignedTake& truth, const BodyPart& part)
{
    if (!(weight >= 0 && weight <= 1))
        refuse("A blend of two takes has a weight from 0 to 1", "0 is the first take, 1 the second.");
    const auto ascends = [](const LearnedBlend& a, const LearnedBlend& b) { return a.weight >= b.weight; };
    if (learned.size() < 2 || learned.front().weight != 0 || learned.back().weight != 1 ||
        std::adjacent_find(learned.begin(), learned.end(), ascends) != learned.end())
        refuse("The learned trajectories do not reach from one take to the other",
               "Give them in the order of their weights, the first with 0, the last with 1.");
    const auto above = std::find_if(learned.begin() + 1, learned.end(),
                                    [weight](const LearnedBlend& blend) { return blend.weight >= weight; });
    return {.fromTakes =
                errorsOf(reconstruction, between(learned.front(), learned.back(), weight), truth, part),
            .fromNearby = errorsOf(reconstruction, between(*(above - 1), *above, weight), truth, part)};
}

} // namespace quadrille
