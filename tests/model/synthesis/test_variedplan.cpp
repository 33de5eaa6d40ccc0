// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/geometry/procrustes.h"
#include "model/synthesis/clips/frameprovenance.h"
#include "model/synthesis/finishing/loop.h"
#include "model/synthesis/finishing/variedplan.h"
#include "tests/model/synthesis/cliptest.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;

namespace {

const TubeTakes& variedTakes()
{
    static const TubeTakes only(threeTakes());
    return only;
}

/// Plays frames 4 to 14 of the first take, comes back to 6, goes elsewhere, and comes back to 8.
const Walk& returningWalk()
{
    static const Walk walk{{{4, 14}, {6, 13}, {50, 52}, {8, 12}}};
    return walk;
}

/// Captured frames with a bulge that grows along the tube, all moved over the ground.
TakeVariation bulging(NodeIndex first, NodeIndex last, double size, const GroundMotion& elsewhere = {})
{
    TakeVariation variation{.name = "variations/tube/1", .first = first, .last = last, .positions = {}};
    for (NodeIndex node = first; node <= last; ++node) {
        std::vector<Vec3f> pose = variedTakes().placed(node, {});
        const double swell = size * (1 + 0.3 * std::sin(0.4 * node));
        for (Vec3f& p : pose)
            p.x() *= static_cast<float>(1 + swell * p.z());
        moveFrame(pose, elsewhere, Ground(UpAxis::Z));
        variation.positions.insert(variation.positions.end(), pose.begin(), pose.end());
    }
    return variation;
}

std::vector<std::optional<std::size_t>> chosen(const Walk& walk, std::span<const TakeVariation> variations)
{
    std::vector<std::optional<std::size_t>> chosen;
    for (const SpanDraw& span :
         drawRepeats(variedTakes().plan(walk), variedTakes().character.layout(), variations))
        chosen.push_back(span.variation);
    return chosen;
}

VariedPlan varied(const Walk& walk, std::span<const TakeVariation> variations,
                  const VariedPlanSettings& settings = {})
{
    ClipPlan plan = variedTakes().plan(walk);
    const auto spans = drawRepeats(plan, variedTakes().character.layout(), variations);
    return variedPlan(variedTakes().character, std::move(plan), spans, variations, {}, settings);
}

Clip clipOf(const VariedPlan& varied)
{
    return makeClip(varied.character, varied.plan);
}

/// The largest second difference of a vertex in some frames of a clip, metres.
double roughness(const Clip& clip, std::int64_t first, std::int64_t last)
{
    double largest = 0;
    for (std::int64_t f = first + 1; f < last; ++f) {
        for (std::size_t v = 0; v < clip.frame(f).size(); ++v)
            largest = std::max(
                largest, static_cast<double>(
                             (clip.frame(f - 1)[v] - 2 * clip.frame(f)[v] + clip.frame(f + 1)[v]).norm()));
    }
    return largest;
}

constexpr std::optional<std::size_t> captured;

} // namespace

TEST(Repeats, AreDrawnFromOneVariationAfterTheOther)
{
    const std::vector<TakeVariation> two{bulging(4, 14, 0.1), bulging(4, 14, 0.2)};
    EXPECT_THAT(chosen(returningWalk(), two), ElementsAre(captured, 0U, captured, 1U));
    const Walk often{{{4, 14}, {6, 13}, {8, 14}, {6, 13}, {7, 12}}};
    EXPECT_THAT(chosen(often, two), ElementsAre(captured, 0U, 1U, 0U, 1U));
    EXPECT_THAT(chosen(often, {}), ElementsAre(captured, captured, captured, captured, captured));
}

TEST(Repeats, AreOnlyWhatWasShownBefore)
{
    // The second span shows other frames, the third some of both.
    const Walk walk{{{2, 6}, {10, 14}, {5, 11}}};
    const std::vector<TakeVariation> one{bulging(0, 19, 0.1)};
    EXPECT_THAT(chosen(walk, one), ElementsAre(captured, captured, 0U));
    // A variation of frames that were not shown yet would vary nothing that comes again.
    const std::vector<TakeVariation> between{bulging(7, 9, 0.1)};
    EXPECT_THAT(chosen(walk, between), ElementsAre(captured, captured, captured));
    // Those of another take do not count.
    const std::vector<TakeVariation> other{bulging(20, 39, 0.1)};
    EXPECT_THAT(chosen(walk, other), ElementsAre(captured, captured, captured));
    const auto spans = drawRepeats(variedTakes().plan(walk), variedTakes().character.layout(), other);
    EXPECT_TRUE(!spans[0].isRepeat && !spans[1].isRepeat && spans[2].isRepeat);
    EXPECT_EQ(spans[2].frames, (WalkSpan{5, 11}));
}

TEST(VariedPlan, ShowsVariationsFrameByFrame)
{
    const std::vector<TakeVariation> variations{bulging(4, 14, 0.1)};
    const ClipPlan before = variedTakes().plan(returningWalk());
    const Clip plain = makeClip(variedTakes().character, before);
    const VariedPlan made = varied(returningWalk(), variations, {.easeSeconds = 0.08});
    const Clip clip = clipOf(made);
    ASSERT_EQ(clip.frameCount(), plain.frameCount());
    for (std::int64_t f = 0; f < clip.frameCount(); ++f) {
        const FrameProvenance& origin = clip.origins[static_cast<std::size_t>(f)];
        const double moved = largestDistance(clip.frame(f), plain.frame(f));
        EXPECT_EQ(origin.source, plain.origins[static_cast<std::size_t>(f)].source);
        const std::size_t span = spanAt(before, f);
        if (isBetweenSpans(before, f)) {
            EXPECT_FALSE(origin.isSingle());
        } else if (span == 0 || span == 2) {
            EXPECT_TRUE(origin.isCaptured()) << f;
            EXPECT_EQ(moved, 0) << f;
        } else {
            EXPECT_EQ(origin.destinationVariation, 1) << f;
            EXPECT_GT(moved, 1e-3) << f;
        }
        // Two frames of ease at both ends: 13 is one of them, 12 is not.
        if (span == 1 && origin.source == 13) {
            EXPECT_EQ(origin.sourceVariation, 0);
            EXPECT_TRUE(origin.lambda > 0.5 && origin.lambda < 1);
        }
        if (span == 1 && origin.source == 12) {
            EXPECT_EQ(origin, (FrameProvenance{12, 12, 0, false, 1, 1}));
        }
    }
}

TEST(VariedPlan, LaysVariationsOntoWhatWasCaptured)
{
    const Clip plain = makeClip(variedTakes().character, variedTakes().plan(returningWalk()));
    for (const auto& [first, last] : {std::pair(0, 19), std::pair(5, 12)}) {
        const std::vector<TakeVariation> elsewhere{bulging(first, last, 0, {0.8, Vec2d(3, -2)})};
        const Clip clip = clipOf(varied(returningWalk(), elsewhere));
        for (std::int64_t f = 0; f < clip.frameCount(); ++f)
            EXPECT_LT(largestDistance(clip.frame(f), plain.frame(f)), 5e-5) << first << " " << f;
    }
}

TEST(VariedPlan, SharesOutWhatTheWayOfAVariationIsOff)
{
    // A variation that drifts evenly sideways by 0.19 m.
    TakeVariation drifting = bulging(0, 19, 0);
    const std::size_t vertices = variedTakes().character.vertexCount();
    for (std::size_t v = 0; v < drifting.positions.size(); ++v)
        drifting.positions[v].x() += 0.01F * static_cast<float>(v / vertices);
    const Clip plain = makeClip(variedTakes().character, variedTakes().plan(returningWalk()));
    const Clip clip = clipOf(varied(returningWalk(), std::vector{drifting}));
    for (std::int64_t f = 0; f < clip.frameCount(); ++f)
        EXPECT_LT(largestDistance(clip.frame(f), plain.frame(f)), 5e-5) << f;
}

TEST(VariedPlan, EvensOutAWayByFitsAndStarts)
{
    TakeVariation jumping = bulging(0, 19, 0);
    const std::size_t vertices = variedTakes().character.vertexCount();
    for (std::size_t v = 0; v < jumping.positions.size(); ++v)
        jumping.positions[v].y() += v / vertices < 10 ? 0.F : 0.1F;
    // As the first and the last frame stay, 0.1 m come back over 19 steps.
    const auto leap = [&](double evening) {
        const VariedPlan made = varied({{{4, 14}, {6, 13}}}, std::vector{jumping}, {.wayEvening = evening});
        const VariedPlan plain = varied({{{4, 14}, {6, 13}}}, {});
        double largest = 0;
        for (std::size_t f = 1; f < made.plan.frames.size(); ++f)
            largest = std::max(largest, ((made.plan.frames[f].centre - plain.plan.frames[f].centre) -
                                         (made.plan.frames[f - 1].centre - plain.plan.frames[f - 1].centre))
                                            .norm());
        return largest;
    };
    EXPECT_NEAR(leap(0), 0.1 - 0.1 / 19, 1e-3);
    // A step evened out by a Gaussian of two frames is nowhere steeper than 1 / (2 √(2 π)) of it.
    EXPECT_NEAR(leap(0.08), 0.1 / (2 * std::sqrt(2 * std::numbers::pi)) - 0.1 / 19, 1e-3);
}

TEST(VariedPlan, EasesFromCapturedFramesToVariedOnesAndBack)
{
    const Walk walk{{{3, 15}, {5, 16}}};
    const std::int64_t first = variedTakes().plan(walk).spanStarts[1];
    const auto clipWith = [&](double size, double ease) {
        return clipOf(varied(walk, std::vector{bulging(6, 15, size)}, {.easeSeconds = ease}));
    };
    const auto roughnessOf = [&](const Clip& clip) { return roughness(clip, first, first + 11); };
    const Clip plain = clipWith(0, 0);
    const Clip abrupt = clipWith(0.05, 0);
    double jump = 0;
    for (std::int64_t f = first; f < plain.frameCount(); ++f)
        jump = std::max(jump, largestDistance(plain.frame(f), abrupt.frame(f)));
    // 3 x² − 2 x³ in four steps bends by 3/16 of its height at most; a tenth of that for the variation's own.
    EXPECT_LT(roughnessOf(clipWith(0.05, 0.12)), roughnessOf(plain) + 1.1 * 3 / 16 * jump);
    EXPECT_GT(roughnessOf(abrupt), 0.5 * jump);
}

TEST(VariedPlan, KeepsTheCentreOnThePlan)
{
    const std::vector<TakeVariation> variations{bulging(4, 14, 0.1)};
    const VariedPlan made = varied(returningWalk(), variations);
    const Clip clip = clipOf(made);
    for (std::int64_t f = 0; f < clip.frameCount(); ++f)
        EXPECT_LT((centroid(clip.frame(f)) - made.plan.frames[static_cast<std::size_t>(f)].centre).norm(),
                  1e-4)
            << f;
}

TEST(VariedPlan, IsTheSameForAnyNumberOfThreads)
{
    const std::vector<TakeVariation> variations{bulging(5, 12, 0.1), bulging(4, 14, 0.2)};
    const Clip many = clipOf(varied(returningWalk(), variations));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(many.positions == clipOf(varied(returningWalk(), variations)).positions);
}

TEST(VariedPlan, RefusesVariationsOfOtherMeshes)
{
    std::vector<TakeVariation> variations{bulging(4, 14, 0.1)};
    variations.front().positions.pop_back();
    try {
        varied(returningWalk(), variations);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::VertexCountMismatch);
    }
}

TEST(FrameOrigins, NameWhatLiesBetweenAFrameAndItsVariation)
{
    const FrameProvenance frame{3, 3};
    const FrameProvenance drawn{3, 3, 0, false, 2, 2};
    const FrameProvenance other{7, 7, 0, false, 1, 1};
    EXPECT_TRUE(frame.isCaptured() && !drawn.isCaptured() && drawn.isSingle());
    EXPECT_EQ(originBetween(frame, drawn, 0.25), (FrameProvenance{3, 3, 0.25, false, 0, 2}));
    EXPECT_EQ(originBetween(drawn, other, 0.75), (FrameProvenance{3, 7, 0.75, false, 2, 1}));
    EXPECT_EQ(originBetween(drawn, {3, 7, 0.8, false, 2, 1}, 0.25),
              (FrameProvenance{3, 7, 0.2, false, 2, 1}));
    // A blend of the frame itself is no blend of its variation.
    EXPECT_EQ(originBetween(drawn, {3, 7, 0.8, false, 0, 1}, 0.25), drawn);
}
