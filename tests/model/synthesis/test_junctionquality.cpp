// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/graph/essentialgraph.h"
#include "model/graph/motiongraph.h"
#include "model/synthesis/quality/junctionreport.h"
#include "model/synthesis/quality/junctionspeeds.h"
#include "model/transition/acceleration.h"
#include "tests/model/sequence/realtakes.h"
#include "tests/model/synthesis/cliptest.h"

#include <atomic>
#include <gtest/gtest.h>
#include <set>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;

namespace {

/// What junctions of some takes are judged by.
struct Subject
{
    CharacterFrames character;
    RootPoses roots;
    std::vector<FrameMeasure> measures;

    Subject(const std::vector<MeshSequence>& takes, UpAxis up)
        : character(takes), roots(rootPoses(character, up))
    {
        roots.supports = findSupports(character, up);
        roots.stances = findStances(character, up);
        measures = frameMeasures(character, roots.supports, up);
    }
    JunctionMeasures judge(const Transition& transition, const BlendSettings& blend = {}) const
    {
        return JunctionJudge(character, roots, measures).judge(transition, blend);
    }
};

/// One take twice: of 30 frames, the second time elsewhere; its lowest vertices are said to stand.
std::vector<MeshSequence> twice()
{
    MeshSequence take = swayingTube(tubeTopology(12, 9), 12, 30, 0.005);
    MeshSequence other = movedOverGround(take, {2.2, Vec2d(-7, 3)});
    for (MeshSequence* sequence : {&take, &other})
        sequence->contacts = {{"left", {FrameIndex(0), FrameIndex(29)}}};
    return {take, other};
}

const Subject& subject()
{
    static const Subject only(twice(), UpAxis::Z);
    return only;
}

} // namespace

TEST(JunctionQuality, FindsNothingAmissWhereOneMotionGoesOn)
{
    const JunctionMeasures measures = subject().judge(advancingTogether(10, 49, 10));
    EXPECT_TRUE(measures.isGood());
    const auto valueOf = [&](JunctionCriterion criterion) { return measures[criterion]; };
    // The motion is as it was; rounding of single precision, times fps², is what is added.
    const JunctionValue acceleration = valueOf(JunctionCriterion::Acceleration);
    EXPECT_LT(acceleration.value, acceleration.limit / 1.5 * 1.01);
    double mean = 0;
    for (std::size_t f = 10; f < 20; ++f)
        mean += std::pow(*subject().measures[f].acceleration, 2) / 10;
    EXPECT_NEAR(acceleration.value, std::sqrt(mean), 0.02 * std::sqrt(mean));
    const JunctionValue step = valueOf(JunctionCriterion::CentreStep);
    double largest = 0;
    double largestAround = 0;
    for (std::size_t f = 2; f < 27; ++f) {
        const double length = (subject().roots.centres[f + 1] - subject().roots.centres[f]).norm();
        largestAround = std::max(largestAround, length);
        if (f >= 10 && f < 19)
            largest = std::max(largest, length);
    }
    EXPECT_NEAR(step.value, largest, 1e-5);
    EXPECT_NEAR(step.limit, 1.5 * largestAround, 1e-5);
    EXPECT_NEAR(valueOf(JunctionCriterion::Volume).value, 0, 1e-4);
    EXPECT_GT(valueOf(JunctionCriterion::Frozen).value, 0.5);
    EXPECT_TRUE(valueOf(JunctionCriterion::FootSlip).isMeasured);
    EXPECT_NEAR(valueOf(JunctionCriterion::FootSlip).ratio, 1 / 1.5, 0.2);
}

TEST(JunctionQuality, FindsPosesThatStandStill)
{
    // Between two takes that are alike, a warp that stops both shows one pose for four frames.
    Transition transition{.frames = {10, 49}, .sourceWindow = 10, .destinationWindow = 10};
    transition.path = {{10, 40}, {11, 41}, {12, 42}, {12, 42}, {12, 42}, {12, 42}, {13, 43},
                       {14, 44}, {15, 45}, {16, 46}, {17, 47}, {18, 48}, {19, 49}};
    const JunctionValue frozen = subject().judge(transition)[JunctionCriterion::Frozen];
    EXPECT_TRUE(frozen.isMeasured);
    EXPECT_FALSE(frozen.isGood());
    EXPECT_LT(frozen.value, 0.01);
    EXPECT_TRUE(
        subject().judge(transition, {.timing = BlendTiming::Smooth})[JunctionCriterion::Frozen].isGood());
}

TEST(JunctionQuality, FindsJerksAndLeaps)
{
    // From one end of the motion to another in three frames.
    const JunctionMeasures measures = subject().judge(advancingTogether(1, 58, 3));
    EXPECT_FALSE(measures.isGood());
    EXPECT_FALSE(measures[JunctionCriterion::Acceleration].isGood());
    EXPECT_GT(measures.worstRatio(), 2);
    EXPECT_GE(measures.worstAcceleration, measures[JunctionCriterion::Acceleration].value);
}

TEST(JunctionSpeeds, FeetSlideAsFastAsTheyAreMoved)
{
    const Transition transition = advancingTogether(10, 49, 10);
    const ClipPlan plan = planClip(subject().roots, Walk{{{5, 10}, {49, 54}}}, std::span(&transition, 1));
    Clip clip = makeClip(subject().character, plan);
    clip.fps = 25;
    const std::size_t vertices = clip.topology->vertexCount();
    for (std::size_t i = vertices; i < clip.positions.size(); ++i)
        clip.positions[i] = clip.positions[i - vertices] + Vec3f(0.01F, 0, 0);
    const auto slide =
        footSlide(clip, plan.junctions.front(), subject().roots, stancesOf(clip, subject().roots.stances));
    ASSERT_TRUE(slide.has_value());
    EXPECT_NEAR(*slide, 0.25, 1e-4); // a centimetre in each of 25 frames; positions are single precision
}

TEST(JunctionSpeeds, AJumpIsTheDifferenceOfTheVelocitiesAtBothEnds)
{
    ClipPlan plan{.up = UpAxis::Y, .frames = std::vector<PlannedFrame>(10)};
    constexpr double fps = 10;
    for (std::size_t f = 0; f < 10; ++f) {
        const auto frame = static_cast<double>(f);
        // 1 m/s along x, then 3 m/s along z; what happens between counts as little as going up and down.
        plan.frames[f].centre = f <= 3   ? Vec3d(0.1 * frame, 0.5 * frame, 0)
                                : f >= 6 ? Vec3d(8, -frame, 0.3 * frame)
                                         : Vec3d(5, 5, 5);
    }
    const ClipPlan::Junction junction{.frames = {3, 20}, .first = 3, .last = 6};
    ASSERT_TRUE(speedJump(plan, junction, fps).has_value());
    EXPECT_NEAR(*speedJump(plan, junction, fps), std::sqrt(10.0), 1e-12);
    EXPECT_FALSE(speedJump(plan, {.frames = {0, 20}, .first = 0, .last = 6}, fps).has_value());
    EXPECT_FALSE(speedJump(plan, {.frames = {3, 20}, .first = 3, .last = 9}, fps).has_value());
}

TEST(JunctionReport, DrawsAsManyPairsAsAsked)
{
    std::vector<FramePair> pairs;
    for (int i = 0; i < 1000; ++i)
        pairs.push_back({i, i + 1});
    const std::vector<FramePair> drawn = drawPairs(pairs, 100, 5);
    ASSERT_EQ(drawn.size(), 100U);
    for (std::size_t i = 1; i < drawn.size(); ++i)
        EXPECT_LT(drawn[i - 1].source, drawn[i].source);
    EXPECT_EQ(drawPairs(pairs, 100, 5), drawn);
    EXPECT_NE(drawPairs(pairs, 100, 6), drawn);
    EXPECT_EQ(drawPairs(pairs, 2000, 5), pairs);
    EXPECT_TRUE(drawPairs(pairs, 0, 5).empty());
    // Each pair has its chance: of 200 draws a tenth, ± five standard deviations.
    std::vector<int> counts(10, 0);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        for (const FramePair& pair : drawPairs({pairs.begin(), pairs.begin() + 10}, 1, seed))
            ++counts[static_cast<std::size_t>(pair.source)];
    }
    for (const int count : counts)
        EXPECT_NEAR(count, 20, 22);
}

namespace {

/// A report with all that it needs.
struct Study
{
    Subject subject;
    Table<float> distances;
    Table<float> accelerations;
    TransitionSettings settings;
    TransitionTable transitions;
    TransitionCosts costs;
    Digraph graph;

    Study(const std::vector<MeshSequence>& takes, UpAxis up, const TransitionSettings& how)
        : subject(takes, up)
        , distances(poseDistances(subject.character).distances)
        , accelerations(accelerationDifferences(subject.character, how.fps))
        , settings(how)
        , transitions(transitionTable(distances, subject.character.layout(), settings))
        , costs(*transitions.cost, *transitions.length, static_cast<double>(distances.maxCoeff()),
                subject.character.layout())
        , graph(essentialGraph(costs, 0.01).graph)
    {
    }
    JunctionReport report(const JunctionOptions& options, const Progress& progress = {}) const
    {
        return report(graph, options, progress);
    }
    JunctionReport report(const Digraph& of, const JunctionOptions& options,
                          const Progress& progress = {}) const
    {
        return judgeJunctions({.character = subject.character,
                               .roots = subject.roots,
                               .distances = distances,
                               .accelerations = accelerations,
                               .transitions = transitions,
                               .settings = settings,
                               .graph = of,
                               .costs = costs,
                               .alpha = 0.01},
                              options, progress);
    }
};

const Study& study()
{
    static const Study only(threeTakes(), UpAxis::Z, {.shortestWindow = 4, .longestWindow = 8});
    return only;
}

} // namespace

TEST(JunctionReport, HasARowForEachTransition)
{
    const JunctionReport report = study().report({.count = 20, .minima = 0});
    ASSERT_EQ(report.rows.size(), 20U);
    int good = 0;
    int goodAccelerations = 0;
    for (const JunctionRow& row : report.rows) {
        const Edge* edge = study().graph.find(row.frames.source, row.frames.destination);
        ASSERT_TRUE(edge && edge->kind == EdgeKind::Transition);
        EXPECT_EQ(row.length, study().transitions.length(row.frames.source, row.frames.destination));
        EXPECT_EQ(row.predictors[static_cast<std::size_t>(JunctionPredictor::Weight)], edge->weight);
        const double sum = row.predictors[static_cast<std::size_t>(JunctionPredictor::Sum)];
        EXPECT_NEAR(sum, study().transitions.cost(row.frames.source, row.frames.destination), 1e-5 * sum);
        EXPECT_DOUBLE_EQ(row.predictors[static_cast<std::size_t>(JunctionPredictor::Mean)], sum / row.length);
        EXPECT_EQ(row.predictors[static_cast<std::size_t>(JunctionPredictor::Cost)],
                  static_cast<double>(study().costs.cost()(row.frames.source, row.frames.destination)));
        EXPECT_EQ(row.source, JunctionSource::Graph);
        good += row.measures.isGood() ? 1 : 0;
        goodAccelerations += row.measures[JunctionCriterion::Acceleration].isGood() ? 1 : 0;
    }
    EXPECT_EQ(report.good, good);
    EXPECT_EQ(report.bad, 20 - good);
    EXPECT_EQ(report.criteria[0].good, goodAccelerations);
    EXPECT_EQ(report.criteria[0].measured, 20);
    EXPECT_LE(report.criteria[0].median, report.criteria[0].ninetieth);
    EXPECT_LE(report.criteria[0].ninetieth, report.criteria[0].greatest);
    // No vertex of a swaying tube stands.
    EXPECT_EQ(report.criteria[static_cast<std::size_t>(JunctionCriterion::FootSlip)].measured, 0);
    EXPECT_FALSE(report.predictors[0].areas[static_cast<std::size_t>(JunctionCriterion::FootSlip)]);
    EXPECT_TRUE(report.predictors[0].rankCorrelation);
}

TEST(JunctionReport, TellsByMinimaAsWellWhatCostsSay)
{
    const std::vector<FramePair> minima = costMinima(study().costs);
    ASSERT_GT(minima.size(), 5U);
    // Without its transitions that are minima, all but the first.
    const auto all = study().graph.edges();
    std::vector<Edge> edges(all.begin(), all.end());
    std::erase_if(edges, [&](const Edge& edge) {
        return edge.kind == EdgeKind::Transition &&
               std::ranges::find(minima.begin() + 1, minima.end(), FramePair{edge.from, edge.to}) !=
                   minima.end();
    });
    const Digraph graph(study().subject.character.frameCount(), std::move(edges));
    const JunctionReport alone = study().report(graph, {.count = 20, .minima = 0});
    const JunctionReport report = study().report(graph, {.count = 20, .minima = 5});
    const std::size_t drawn = alone.rows.size();
    ASSERT_GT(drawn, 0U);
    ASSERT_EQ(report.rows.size(), drawn + 5);
    EXPECT_EQ(report.drawn, static_cast<int>(drawn));
    int bad = 0;
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        const JunctionRow& row = report.rows[i];
        EXPECT_EQ(row.source, i < drawn ? JunctionSource::Graph : JunctionSource::Minima);
        bad += row.measures.isGood() ? 0 : 1;
        if (i < drawn)
            continue;
        EXPECT_EQ(graph.find(row.frames.source, row.frames.destination), nullptr);
        EXPECT_NE(std::ranges::find(minima, row.frames), minima.end());
        EXPECT_NEAR(row.predictors[static_cast<std::size_t>(JunctionPredictor::Weight)],
                    study().costs.weight(row.frames.source, row.frames.destination, 0.01), 1e-12);
    }
    EXPECT_EQ(report.bad, bad);
    // What the graph's transitions are like does not change by what is drawn beside them.
    EXPECT_EQ(report.good, alone.good);
    EXPECT_EQ(report.criteria[0].measured, alone.criteria[0].measured);
    EXPECT_EQ(report.criteria[0].greatest, alone.criteria[0].greatest);
    EXPECT_NE(report.predictors[0].rankCorrelation, alone.predictors[0].rankCorrelation);
}

TEST(JunctionReport, IsTheSameOnAnyNumberOfThreads)
{
    const JunctionReport parallel = study().report({.count = 12, .minima = 4});
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const JunctionReport serial = study().report({.count = 12, .minima = 4});
    ASSERT_EQ(serial.rows.size(), parallel.rows.size());
    for (std::size_t i = 0; i < serial.rows.size(); ++i) {
        EXPECT_EQ(serial.rows[i].frames, parallel.rows[i].frames);
        for (std::size_t c = 0; c < junctionCriteria; ++c)
            EXPECT_EQ(serial.rows[i].measures.values[c].value, parallel.rows[i].measures.values[c].value);
    }
}

TEST(JunctionReport, StopsWhenCancelled)
{
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.3)
            token.cancel();
    });
    try {
        study().report({.count = 12}, progress);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    }
    EXPECT_THROW(study().report({.count = -1}), Error);
    EXPECT_THROW(study().report({.minima = -1}), Error);
}

TEST(JunctionsOfRealTakes, AreBetterWhereTheyAreBlendedGently)
{
    if (!realTake("walk_1"))
        GTEST_SKIP() << "no real takes";
    std::vector<MeshSequence> takes;
    for (const char* name : {"walk_1", "jog_1", "kick_2"})
        takes.push_back(*realTake(name));
    const Study real(takes, UpAxis::Y, {.fps = 30, .cost = TransitionCost::Mean});
    const JunctionReport paper = real.report({.count = 40, .minima = 0});
    const JunctionReport gentle = real.report({.count = 40,
                                               .minima = 0,
                                               .blend = BlendSettings::gentle(),
                                               .correction = ContactCorrectionSettings()});
    EXPECT_GT(gentle.good, paper.good + 10);
    const auto slips = [](const JunctionReport& report) {
        return report.criteria[static_cast<std::size_t>(JunctionCriterion::FootSlip)];
    };
    EXPECT_GT(slips(gentle).measured, 10);
    EXPECT_LT(slips(gentle).median, slips(paper).median);
}
