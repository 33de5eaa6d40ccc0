// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/blenderrors.h"

#include <numeric>

namespace quadrille {

namespace {

double mean(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
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

BlendErrors blendErrors(const PoseReconstruction& reconstruction, std::span<const LatentShare> takes,
                        std::span<const LatentShare> nearby, const AlignedTake& truth, const BodyPart& part)
{
    return {.fromTakes = errorsOf(reconstruction, latentBlend(takes), truth, part),
            .fromNearby = errorsOf(reconstruction, latentBlend(nearby), truth, part)};
}

} // namespace quadrille
