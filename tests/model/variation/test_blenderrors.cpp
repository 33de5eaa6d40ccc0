// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/blenderrors.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace quadrille {
namespace {

constexpr Eigen::Index blendFrames = 12;
const std::vector<double> weights = {0, 0.5, 1};

/// One vertex on a circle whose radius is 1 + weight.
AlignedTake trueBlend(double weight)
{
    AlignedTake take{
        .name = "blend", .warp = {}, .poses = {}, .placements = std::vector<RigidMotion>(blendFrames)};
    for (int f = 0; f < blendFrames; ++f) {
        const double angle = 2 * std::numbers::pi * f / blendFrames;
        take.poses.push_back((Vec3d(std::cos(angle), std::sin(angle), 0) * (1 + weight)).cast<float>());
    }
    return take;
}

/// A model that learned the weights; its latents are the poses, but for those of the blend in the middle,
/// which lie on a circle of another radius: 1.5 would be right between those of its takes (CVS Fig. 6).
struct Learned
{
    GpdmState state;
    RowMatrix rows;
    std::vector<RowMatrix> blends;
    BodyPart part;

    explicit Learned(double radius)
    {
        const auto count = static_cast<Eigen::Index>(weights.size());
        rows.resize(count * blendFrames, 3);
        state.latents.resize(count * blendFrames, 3);
        for (Eigen::Index b = 0; b < count; ++b) {
            const AlignedTake truth = trueBlend(weights[static_cast<std::size_t>(b)]);
            RowMatrix latents(blendFrames, 3);
            for (Eigen::Index f = 0; f < blendFrames; ++f) {
                rows.row(b * blendFrames + f) = truth.poses[static_cast<std::size_t>(f)].cast<double>();
                latents.row(f) = rows.row(b * blendFrames + f);
                if (b == 1)
                    latents.row(f) *= radius / 1.5;
            }
            state.latents.middleRows(b * blendFrames, blendFrames) = latents;
            blends.push_back(latents);
        }
        state.hyperparameters.alpha3 = 1e6;
        part.vertices = {VertexIndex(0)};
    }

    BlendErrors errors(double weight) const
    {
        const PoseReconstruction reconstruction(state, rows, Eigen::RowVectorXd::Zero(3));
        const BlendNeighbours near = blendNeighbours(weights, weight);
        const std::array takes{LatentShare{blends.front(), 1 - weight}, LatentShare{blends.back(), weight}};
        const std::array nearby{LatentShare{blends[near.first], near.share},
                                LatentShare{blends[near.second], 1 - near.share}};
        return blendErrors(reconstruction, takes, nearby, trueBlend(weight), part);
    }
};

TEST(BlendErrors, AreThoseOfTheTrainingPosesAtLearnedWeights)
{
    const Learned learned(1.2);
    for (const double weight : weights)
        EXPECT_LT(learned.errors(weight).meanFromNearby(), 1e-3);
    EXPECT_EQ(learned.errors(0).fromTakes, learned.errors(0).fromNearby);
    EXPECT_EQ(learned.errors(0.3).fromTakes.size(), std::size_t{blendFrames});
}

TEST(BlendErrors, AreSmallerBesideALearnedBlendThatDoesNotLieInTheMiddle)
{
    for (const double weight : {0.15, 0.25, 0.4}) {
        const BlendErrors errors = Learned(1.2).errors(weight);
        EXPECT_LT(errors.meanFromNearby(), 0.5 * errors.meanFromTakes()) << weight;
    }
    const BlendErrors straight = Learned(1.5).errors(0.25);
    EXPECT_NEAR(straight.meanFromNearby(), straight.meanFromTakes(), 1e-6);
}

} // namespace
} // namespace quadrille
