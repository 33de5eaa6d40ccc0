// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"
#include "model/project/results/openanimation.h"
#include "model/project/results/runexports.h"
#include "model/project/steps/storedwalk.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/project/tubeproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::Not;

namespace {

/// Somebody works with one value of a project after the other in one session.
class ResultSessionTest : public TubeProject
{
protected:
    ResultSessionTest()
    {
        project.graphs.resize(1);
        AnimationEntry animation;
        animation.name = "dance";
        animation.constraints = {KeyEntry{.sequence = "calm", .frame = FrameIndex(2)},
                                 KeyEntry{.sequence = "wild", .frame = FrameIndex(9), .time = 1.2}};
        project.animations = {animation};
    }
    AnimationEntry& animation() { return project.animations.front(); }
    KeyEntry& secondKey() { return std::get<KeyEntry>(animation().constraints[1]); }
    WorkingProject working() const { return {project, folder / "p.quadrille", session}; }
    AnimationResultPointer dance() { return openAnimation(working(), "dance"); }

    /// Steps that were computed since the last call, and no step twice.
    std::vector<std::string> computedNow()
    {
        std::vector<std::string> names;
        for (const auto& [step, count] : session->computed()) {
            const int before = std::exchange(m_before[step], count);
            EXPECT_LE(count - before, 1) << step;
            if (count > before)
                names.push_back(step);
        }
        return names;
    }
    std::int64_t openedNow()
    {
        const std::int64_t opened = session->sources()->opened();
        return opened - std::exchange(m_openedBefore, opened);
    }

    std::shared_ptr<ResultSession> session = std::make_shared<ResultSession>();

private:
    std::map<std::string, int> m_before;
    std::int64_t m_openedBefore = 0;
};

} // namespace

TEST_F(ResultSessionTest, OpensSourcesOnceWhileSomebodyHoldsThem)
{
    const auto first = dance();
    EXPECT_EQ(openedNow(), 2);
    secondKey().time = 1.4;
    project.sequences[0].range = FrameRange{FrameIndex(0), FrameIndex(15)};
    dance();
    EXPECT_EQ(openedNow(), 0);
    // Another axis makes other frames, of all of them.
    project.settings.axes.up = UpAxis::Z;
    ProjectResults(working()).opener()->open("calm");
    EXPECT_EQ(openedNow(), 1);
}

TEST_F(ResultSessionTest, OpensASourceAgainThatWasWritten)
{
    const auto first = dance();
    EXPECT_EQ(openedNow(), 2);
    folder.write("wild/f_103.obj", bentTube(0.3, 0.2));
    dance();
    EXPECT_EQ(openedNow(), 1);
}

TEST_F(ResultSessionTest, ComputesAfterAnEditWhatDependsOnIt)
{
    dance();
    EXPECT_THAT(computedNow(), Contains("animations/dance/walk"));
    dance();
    EXPECT_THAT(computedNow(), IsEmpty());
    secondKey().time = 1.4;
    dance();
    EXPECT_THAT(computedNow(), ElementsAre("animations/dance/clip", "animations/dance/walk"));
    animation().post.steps.mirror = true;
    dance();
    EXPECT_THAT(computedNow(), ElementsAre("animations/dance/clip"));
    // Undone: both are in memory still.
    animation().post.steps.mirror = false;
    secondKey().time = 1.2;
    dance();
    EXPECT_THAT(computedNow(), IsEmpty());
}

TEST_F(ResultSessionTest, ComputesEachGraphOnceForAnotherAlpha)
{
    const auto first = dance();
    computedNow();
    project.graphs.front().alpha = 0.02;
    const auto second = dance();
    EXPECT_THAT(computedNow(), ElementsAre("animations/dance/clip", "animations/dance/walk", "graph/graphs"));
    EXPECT_TRUE(first->character->graph.hasTablesOf(second->character->graph));
    EXPECT_EQ(openCharacter(working(), {}, GraphOpening::Compute)->graph.alpha(), 0.02);
    EXPECT_THAT(computedNow(), IsEmpty());
}

TEST_F(ResultSessionTest, ComputesNoWalkForAnExport)
{
    dance();
    computedNow();
    ExportEntry entry;
    entry.name = "dance";
    entry.what = "animations/dance";
    entry.path = "dance.pc2";
    runExports(working(), {entry});
    EXPECT_THAT(computedNow(), IsEmpty());
}

TEST_F(ResultSessionTest, LeavesNothingToARebuildAndFindsAllThatOneLeft)
{
    dance();
    secondKey().time = 1.4;
    dance();
    secondKey().time = 1.2;
    dance();
    EXPECT_THAT(computed(run("animations")), IsEmpty());
    EXPECT_FALSE(computed(run("variations")).empty());
    // Who only looks whether something is there stores what is kept.
    animation().post.steps.mirror = true;
    dance();
    animation().post.steps.mirror = false;
    EXPECT_TRUE(ProjectResults(working()).getIfFresh({clipStepOf("animations/dance")}));
    EXPECT_THAT(computed(run("animations")), IsEmpty());
    session = std::make_shared<ResultSession>();
    computedNow();
    dance();
    ProjectResults(working()).get({clipStepOf("variations/sway/1")});
    EXPECT_THAT(computedNow(), IsEmpty());
}

TEST_F(ResultSessionTest, KnowsAWalkUnderAnotherName)
{
    dance();
    computedNow();
    animation().name = "ball";
    openAnimation(working(), "ball");
    EXPECT_THAT(computedNow(), IsEmpty());
    EXPECT_THAT(computed(run("animations")), IsEmpty());
}

TEST_F(ResultSessionTest, ReadsAWalkAsItWasFound)
{
    const auto opened = dance();
    const AnimationWalk found = animationWalk(animation(), opened->character->graph);
    EXPECT_EQ(opened->walk.solution, found.solution);
    EXPECT_EQ(opened->walk.constraints, found.constraints);
    EXPECT_EQ(storedWalk(walkResult(animation(), opened->character->graph, found), animation(),
                         opened->character->graph)
                  .solution,
              found.solution);
}

TEST_F(ResultSessionTest, OpensAClipAsItWasMade)
{
    animation().post.steps.retime = RetimeSettings{.time = RetimeFactor{1.5}};
    const auto opened = dance();
    const CharacterGraph& graph = opened->character->graph;
    const AnimationClip made =
        animationClip(animation(), graph, opened->character->frames,
                      animationPlan(animation(), graph, opened->walk.solution, std::nullopt));
    EXPECT_EQ(opened->framesBeforeRetime, made.processed.framesBeforeRetime);
    EXPECT_EQ(opened->origins, made.processed.clip.origins);
    EXPECT_EQ(opened->sequence.frameCount(), made.processed.clip.frameCount());
    EXPECT_EQ(opened->plan.frameCount(), made.plan.frameCount());
    EXPECT_EQ(opened->spans.size(), made.spans.size());
}

TEST_F(ResultSessionTest, TellsTheBestSoFarWhileItSeeks)
{
    std::vector<AnimationResultPointer> better;
    const auto last =
        openAnimation(working(), "dance", {}, [&](AnimationResultPointer each) { better.push_back(each); });
    ASSERT_FALSE(better.empty());
    EXPECT_FALSE(better.front()->isFinal);
    EXPECT_TRUE(last->isFinal);
    EXPECT_EQ(better.back()->walk.solution.walk, last->walk.solution.walk);
    EXPECT_EQ(better.back()->origins, last->origins);
}

TEST_F(ResultSessionTest, MakesGraphsOnceForThoseWhoTryAnAlphaThatTheProjectThenTakes)
{
    const auto opened = openCharacter(working(), "", GraphOpening::Compute);
    std::vector<bool> shown; // whether whole
    const GraphsTaker show = [&](const std::shared_ptr<const GraphPair>& edges) {
        shown.push_back(edges->isWhole);
        EXPECT_EQ(edges->alpha, 0.05);
    };
    const auto tried = opened->graph.at(0.05, {}, show);
    EXPECT_EQ(shown, (std::vector{false, true}));
    EXPECT_TRUE(tried->graphs->isWhole);
    EXPECT_EQ(opened->graph.at(0.05, {}, show), tried);
    EXPECT_EQ(shown.size(), 2U);
    computedNow();

    WorkingProject taken = working();
    taken.project.graphs.front().alpha = 0.05;
    const auto after = openCharacter(taken, "", GraphOpening::Compute);
    EXPECT_EQ(computedNow(), std::vector<std::string>{"graph/graphs"});
    EXPECT_EQ(after->graph.at(0.05), tried);
    EXPECT_EQ(after->graph.graph(), tried->graphs->essential);
    EXPECT_TRUE(after->graph.hasTablesOf(opened->graph));
}

TEST(ResultSession, ForgetsWhatNobodyUses)
{
    ResultSession session;
    const auto make = [] { return std::make_shared<const int>(1); };
    const std::weak_ptr<const int> unused = session.shared<const int>("unused", make);
    const auto used = session.shared<const double>("used", [] { return std::make_shared<const double>(2); });
    EXPECT_FALSE(unused.expired()) << "the last one is kept for those who ask next";
    session.forgetUnused();
    EXPECT_TRUE(unused.expired());
    EXPECT_EQ(session.existing<const double>("used"), used);
}

TEST_F(ResultSessionTest, ReadsTheGraphsOfTheProjectsAlphaAsTheirStepLeftThem)
{
    run("graph");
    const auto opened = openCharacter(working(), "", GraphOpening::Compute);
    const CharacterGraph& graph = opened->graph;
    const auto read =
        graph.at(graph.alpha(), {}, [](const auto&) { ADD_FAILURE() << "they were made anew"; });
    const MeasuredGraphs made = measured(
        std::make_shared<const GraphPair>(graphsAt(graph.costs(), read->graphs->minima, graph.alpha())));
    EXPECT_EQ(read->graphs->alpha, graph.alpha());
    EXPECT_EQ(read->graphs->essential, made.graphs->essential);
    EXPECT_EQ(read->graphs->motion, made.graphs->motion);
    for (auto statistics : {&MeasuredGraphs::essential, &MeasuredGraphs::motion}) {
        EXPECT_EQ((*read.*statistics).pathCosts, (made.*statistics).pathCosts);
        EXPECT_EQ((*read.*statistics).transitions, (made.*statistics).transitions);
        EXPECT_EQ((*read.*statistics).connectivity.components, (made.*statistics).connectivity.components);
    }
    EXPECT_EQ(*read->graphs->minima, costMinima(graph.costs(), CostSmoothing::None));
}

TEST_F(ResultSessionTest, ShowsCostsFromAfarBeforeTheyAreRead)
{
    const auto open = [this](GraphOpening opening, std::vector<std::shared_ptr<const CostOverview>>& taken) {
        return openCharacter(working(), "", opening, {}, [&](std::shared_ptr<const CostOverview> overview) {
            taken.push_back(std::move(overview));
        });
    };
    std::vector<std::shared_ptr<const CostOverview>> taken;
    EXPECT_EQ(open(GraphOpening::IfFresh, taken), nullptr);
    EXPECT_TRUE(taken.empty());
    const auto opened = open(GraphOpening::Compute, taken);
    EXPECT_TRUE(taken.empty()) << "there was none yet";
    EXPECT_THAT(computedNow(), Contains("graph/cost-overview"));

    ASSERT_NE(open(GraphOpening::IfFresh, taken), nullptr);
    ASSERT_EQ(taken.size(), 1U);
    const CostOverview made = costOverview(opened->graph.costs().cost(), opened->graph.layout());
    EXPECT_EQ(taken.front()->layout, made.layout);
    EXPECT_EQ(taken.front()->framesOfCell, made.framesOfCell);
    EXPECT_TRUE((taken.front()->least == made.least).all());
    EXPECT_EQ(taken.front()->range.minimum, made.range.minimum);
    EXPECT_EQ(taken.front()->range.maximum, made.range.maximum);
    EXPECT_THAT(computedNow(), IsEmpty());
}

TEST_F(ResultSessionTest, HasWhatIsStoredWithoutALookAtWhatItWasMadeFrom)
{
    run("graph");
    EXPECT_TRUE(std::filesystem::remove(cacheFolder(working().file) / "graph" / "transitions.h5"));
    session = std::make_shared<ResultSession>();
    EXPECT_NE(ProjectResults(working()).stored("graph/cost-overview"), nullptr);
    EXPECT_EQ(ProjectResults(working()).stored("graph/transitions"), nullptr);
    EXPECT_FALSE(ProjectResults(working()).getIfFresh({"graph/cost-overview"}));
    project.graphs.front().slope = 2;
    EXPECT_EQ(ProjectResults(working()).stored("graph/cost-overview"), nullptr);
}

TEST_F(ResultSessionTest, KeepsInMemoryOnlyWhatIsNotToBeStored)
{
    const ProjectResults results(working());
    results.get({"graph/graphs"}, {}, {.onlyInMemory = true});
    EXPECT_THAT(computedNow(), Contains("graph/graphs"));
    EXPECT_FALSE(std::filesystem::exists(cacheFolder(working().file) / "graph/graphs.h5"));
    results.get({"graph/graphs"});
    EXPECT_THAT(computedNow(), IsEmpty());
    EXPECT_TRUE(std::filesystem::exists(cacheFolder(working().file) / "graph/graphs.h5"));
}

TEST_F(ResultSessionTest, LearnsOnAndStopsWithTheBestSoFar)
{
    const std::vector<std::string> steps{"variations/sway/base/model", "variations/sway/tip/model"};
    CancelToken token;
    std::map<std::string, ResultPointer> best;
    std::mutex mutex;
    RebuildOptions options;
    options.improved = [&](const std::string& step, const Result& result) {
        const std::scoped_lock lock(mutex);
        best[step] = std::make_shared<const Result>(result);
        if (step == steps[1])
            token.cancel();
    };
    EXPECT_THROW(ProjectResults(working()).get(steps, Progress(token), options), Error);
    EXPECT_THAT(best, Contains(Key(steps[1])));
    EXPECT_THAT(computedNow(), Not(Contains(steps[1])));
}
