// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Learning five parts of a real body: two gaits and two turns, as in Fig. 9 of the paper.
#include "model/sequence/meshsequence.h"
#include "model/variation/alignment.h"
#include "model/variation/parts/proposedparts.h"
#include "model/variation/reconstructionerror.h"
#include "tests/model/sequence/realtakes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

struct RealPart
{
    std::string name;
    Eigen::Index vertices;
    PartTraining training;
};

/// Empty where the data are missing.
std::vector<RealPart> realParts()
{
    std::vector<TrainingTake> takes;
    for (const char* name : {"walk_1", "jog_1", "walk_turn_left_1", "walk_turn_right_1"}) {
        std::optional<MeshSequence> take = realTake(name);
        if (!take)
            return {};
        takes.push_back({std::move(*take), {}});
    }
    const Alignment alignment = alignTakes(takes, 0);
    const Topology& topology = *takes[0].sequence.topology;
    const ProposedParts proposed = proposeParts(takes[0].sequence.topology, alignment.templatePose);
    const BodyParts body = cutIntoParts(topology, alignment.templatePose, proposed.curves, proposed.parts);
    std::vector<RealPart> parts;
    for (const BodyPart& part : body.parts)
        parts.push_back({part.name, static_cast<Eigen::Index>(part.vertices.size()),
                         partTraining(alignment.takes, part)});
    return parts;
}

/// Changes of steps in steps: √2 where each step goes anywhere, small where they go on.
double roughness(const GpdmState& state, std::span<const RowSpan> spans)
{
    double changes = 0;
    double steps = 0;
    for (const RowSpan& span : spans) {
        for (Eigen::Index i = span.first + 1; i < span.last(); ++i) {
            const Eigen::RowVectorXd after = state.latents.row(i + 1) - state.latents.row(i);
            changes += (after - state.latents.row(i) + state.latents.row(i - 1)).squaredNorm();
            steps += after.squaredNorm();
        }
    }
    return std::sqrt(changes / steps);
}

} // namespace

TEST(RealGpdm, EveryPartIsBelowPrincipalComponentsAndSmooth)
{
    const std::vector<RealPart> parts = realParts();
    if (parts.empty())
        GTEST_SKIP() << "the real takes are not here";
    std::vector<GpdmLearning> learned(parts.size());
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
        learned[i] = learnGpdm(parts[i].training.rows, parts[i].training.spans, {});
    });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const RealPart& part = parts[i];
        const GpdmLearning& learning = learned[i];
        EXPECT_EQ(learning.stop, GpdmStop::Converged) << part.name;
        const double model = modelError(learning.state, part.training.rows, part.vertices);
        const double principal = principalError(part.training.rows, 3, part.vertices);
        EXPECT_LT(model, 0.25 * principal) << part.name;
        EXPECT_LT(roughness(learning.state, part.training.spans), 0.7) << part.name;
        EXPECT_EQ(learning.jitter, 0) << part.name;
    }
}

TEST(RealGpdm, PerturbedStartsAgreeWithinTwoPercent)
{
    const std::vector<RealPart> parts = realParts();
    if (parts.empty())
        GTEST_SKIP() << "the real takes are not here";
    const PartTraining& arm = parts[1].training;
    std::vector<double> finals(5);
    tbb::parallel_for(std::size_t{0}, finals.size(), [&](std::size_t i) {
        // The first start is the same for every seed: what seeds change is the second.
        finals[i] = learnGpdm(arm.rows, arm.spans, {.restarts = 1, .seed = i + 1}).finalObjectives.at(1);
    });
    const auto [least, greatest] = std::minmax_element(finals.begin(), finals.end());
    EXPECT_GT(*greatest, *least) << "or nothing is compared";
    EXPECT_LT(*greatest - *least, 0.02 * std::abs(*least));
}
