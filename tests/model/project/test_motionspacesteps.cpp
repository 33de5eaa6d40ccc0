// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/hybridblend.h"
#include "model/project/results/openlive.h"
#include "model/project/results/openmotionspace.h"
#include "model/project/steps/motionspaceresults.h"
#include "model/project/steps/motionspacesteps.h"
#include "tests/model/project/walkproject.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace quadrille {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class MotionSpaceSteps : public test::WalkProject
{
protected:
    std::shared_ptr<const MotionSpace> opened(const std::string& name)
    {
        return openMotionSpace(ProjectResults({project, folder / "p.quadrille"}), name);
    }
    MotionSpace computed(const std::string& name)
    {
        const auto opener = std::make_shared<SequenceOpener>(project, folder.path());
        return MotionSpaceWork(opener, *findMotionSpace(project, name)).make({});
    }
    using StripProject::computed;
};

void expectSame(const MotionSpace& a, const MotionSpace& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.fps, b.fps);
    EXPECT_EQ(a.isCyclic, b.isCyclic);
    EXPECT_EQ(a.parameters, b.parameters);
    ASSERT_EQ(a.takes.size(), b.takes.size());
    for (std::size_t t = 0; t < a.takes.size(); ++t) {
        EXPECT_EQ(a.takes[t].name, b.takes[t].name);
        EXPECT_EQ(a.takes[t].warp, b.takes[t].warp);
        EXPECT_EQ(a.takes[t].poses, b.takes[t].poses);
        EXPECT_EQ(a.takes[t].steps, b.takes[t].steps);
        EXPECT_EQ(a.takes[t].seconds, b.takes[t].seconds);
    }
    EXPECT_EQ(a.weights.dimension(), b.weights.dimension());
    EXPECT_EQ(a.weights.takeCount(), b.weights.takeCount());
    ASSERT_EQ(a.weights.nodes().size(), b.weights.nodes().size());
    for (std::size_t n = 0; n < a.weights.nodes().size(); ++n) {
        EXPECT_EQ(a.weights.nodes()[n].place, b.weights.nodes()[n].place);
        EXPECT_EQ(a.weights.nodes()[n].shares, b.weights.nodes()[n].shares);
    }
    ASSERT_EQ(a.weights.simplices().size(), b.weights.simplices().size());
    for (std::size_t s = 0; s < a.weights.simplices().size(); ++s) {
        EXPECT_EQ(a.weights.simplices()[s].nodes, b.weights.simplices()[s].nodes);
        EXPECT_EQ(a.weights.simplices()[s].inverse, b.weights.simplices()[s].inverse);
    }
    ASSERT_EQ(a.references.size(), b.references.size());
    for (std::size_t r = 0; r < a.references.size(); ++r) {
        EXPECT_EQ(a.references[r].starts, b.references[r].starts);
        EXPECT_EQ(a.references[r].vertices, b.references[r].vertices);
        EXPECT_EQ(a.references[r].displacements, b.references[r].displacements);
        EXPECT_EQ(a.references[r].unit, b.references[r].unit);
    }
    EXPECT_EQ(a.map.dimension, b.map.dimension);
    EXPECT_EQ(a.map.coefficients, b.map.coefficients);
    EXPECT_EQ(a.map.least, b.map.least);
    EXPECT_EQ(a.map.greatest, b.map.greatest);
    EXPECT_EQ(a.map.meanResidual, b.map.meanResidual);
    EXPECT_EQ(a.map.worstResidual, b.map.worstResidual);
}

} // namespace

TEST_F(MotionSpaceSteps, StoreASpaceThatIsReadBackWhole)
{
    walk().tolerance = 0.004;
    EXPECT_THAT(computed(run("motion_spaces")),
                ElementsAre("motion_spaces/walk/space", "motion_spaces/walk/quality"));
    const auto space = opened("walk");
    EXPECT_TRUE(space->isCyclic);
    EXPECT_FALSE(space->references.empty());
    expectSame(*space, computed("walk"));
}

TEST_F(MotionSpaceSteps, StoreASpaceOfOneTakeThatIsNoCycle)
{
    project.motionSpaces = {spaceOf("bow", {"slow"})};
    walk().takes[0].range = FrameRange{FrameIndex(0), FrameIndex(11)};
    run("motion_spaces");
    const auto space = opened("bow");
    EXPECT_EQ(space->frameCount(), 12U);
    EXPECT_FALSE(space->isCyclic);
    expectSame(*space, computed("bow"));
}

TEST_F(MotionSpaceSteps, NameTheirData)
{
    run("motion_spaces");
    const auto shape = [&](const std::string& name) { return std::get<DataArray>(item(name).content).shape; };
    const auto frames = static_cast<std::int64_t>(opened("walk")->frameCount());
    EXPECT_THAT(shape("motion_spaces/walk/warps"), ElementsAre(2, frames));
    EXPECT_THAT(shape("motion_spaces/walk/parameters"), ElementsAre(2, 1));
    EXPECT_EQ(column<std::int64_t>("motion_spaces/walk/references", "bytes").size(),
              opened("walk")->references.size());
    EXPECT_THAT(column<std::string>("motion-spaces/walk/parameters", "parameter"), ElementsAre("speed"));
    EXPECT_THAT(column<std::string>("motion-spaces/walk/parameters", "unit"), ElementsAre("m/s"));
    const std::vector<double> errors = column<double>("motion-spaces/walk/error", "greatest");
    EXPECT_GT(errors.size(), 20U);
    EXPECT_THAT(errors, ::testing::Each(::testing::Le(walk().tolerance)));
    EXPECT_GT(std::ranges::max(errors), 0.001) << "nothing differs from the non-linear blend";
}

TEST_F(MotionSpaceSteps, AreFreshUntilSomethingTheyNeedChanges)
{
    run("motion_spaces");
    EXPECT_THAT(computed(run("motion_spaces")), IsEmpty());
    walk().tolerance = 0.02;
    EXPECT_THAT(computed(run("motion_spaces")),
                ElementsAre("motion_spaces/walk/space", "motion_spaces/walk/quality"));
}

TEST_F(MotionSpaceSteps, AreKeptWhereTheSpaceIsRenamed)
{
    project.motionSpaces.push_back(spaceOf("steady", {"slow"}));
    const auto session = std::make_shared<ResultSession>();
    const auto open = [&] {
        return openLiveGraph(ProjectResults({project, folder / "p.quadrille", session}), "");
    };
    const auto before = open();
    const auto computed = session->computed();
    EXPECT_FALSE(computed.empty());
    walk().name = "stride";
    const auto after = open();
    EXPECT_EQ(session->computed(), computed);
    EXPECT_EQ(after->content, before->content);
    EXPECT_EQ(after->graph->spaces[0]->name, "stride");
    EXPECT_EQ(after->graph->spaces[0]->takes[0].poses, before->graph->spaces[0]->takes[0].poses);
    // Others find it, too.
    EXPECT_THAT(this->computed(run("transitions/stride/steady/similarity")), IsEmpty());
    walk().tolerance = 0.03;
    EXPECT_NE(open()->content, before->content);
}

TEST_F(MotionSpaceSteps, TurnMirroredTakesTheOtherWay)
{
    // At rest its sides are told from its front and its top.
    std::string rest;
    for (const Vec3f& p : test::swayedTube(0, 0)) {
        const float width = 1 - 0.2F * p.y();
        rest += "v " + std::to_string(width * p.x()) + " " + std::to_string(p.y()) + " " +
                std::to_string(width * p.z() * (p.z() > 0 ? 1.5F : 1)) + "\n";
    }
    folder.write("rest.obj", rest + test::facesText(*test::swayingTopology()));
    project.characters = {test::characterOf("tube", "rest.obj")};
    addTake("left", {.turn = 0.01});
    project.motionSpaces = {spaceOf("turn", {"left", "left"})};
    walk().parameters[0].measure = SpaceMeasure::Turning;
    walk().takes[1].isMirrored = true;
    ASSERT_EQ(failure(), "");
    const auto space = opened("turn");
    EXPECT_NEAR(space->weights.nodes()[0].place[0], 14.3, 0.5); // 0.01 radians a frame
    EXPECT_NEAR(space->weights.nodes()[1].place[0], -14.3, 0.5);
    EXPECT_EQ(space->takes[1].name, "left (mirrored)");
}

TEST_F(MotionSpaceSteps, PlayReversedTakesFromTheirEnd)
{
    project.motionSpaces = {spaceOf("there", {"slow"}), spaceOf("back", {"slow"})};
    for (MotionSpaceEntry& entry : project.motionSpaces)
        entry.takes[0].range = FrameRange{FrameIndex(3), FrameIndex(12)};
    project.motionSpaces[1].takes[0].isReversed = true;
    const auto there = opened("there");
    const auto back = opened("back");
    ASSERT_EQ(there->frameCount(), 10U);
    ASSERT_EQ(back->frameCount(), 10U);
    for (std::size_t f = 0; f < 10; ++f)
        EXPECT_TRUE(std::ranges::equal(there->takes[0].pose(f), back->takes[0].pose(9 - f))) << f;
}

TEST_F(MotionSpaceSteps, CompareTheSpacesOfACharacter)
{
    addTake("bow", {.frames = 20, .period = 60, .step = 0});
    project.motionSpaces.push_back(spaceOf("bow", {"bow"}));
    EXPECT_THAT(computed(run("transitions")),
                ElementsAre("motion_spaces/walk/space", "motion_spaces/bow/space",
                            "transitions/walk/bow/similarity", "transitions/walk/bow/report",
                            "transitions/bow/walk/similarity", "transitions/bow/walk/report"));
    const ProjectResults results({project, folder / "p.quadrille"});
    const auto table = openSimilarities(results, "walk", "bow");
    EXPECT_EQ(*table, similarities(*opened("walk"), *opened("bow")));
    EXPECT_EQ(table, openSimilarities(results, "walk", "bow")) << "it was read twice";
    EXPECT_THAT(
        column<std::string>("transitions/walk/bow/report", "kind"),
        ElementsAre("online", "responsive", "1 computed before", "5 computed before", "10 computed before"));
    const std::vector<double> latencies = column<double>("transitions/bow/walk/report", "mean-latency");
    EXPECT_GT(latencies[1], 0);
    EXPECT_THROW(openSimilarities(results, "walk", "walk"), Error);
    EXPECT_THROW(openSimilarities(results, "walk", "run"), Error);
}

TEST_F(MotionSpaceSteps, SayWhichTakeDoesNotCycleAndWhichStandsStill)
{
    addTake("bow", {.frames = 45, .period = 200});
    walk().takes[1].sequence = "bow";
    EXPECT_THAT(failure(), AllOf(HasSubstr("No cycle"), HasSubstr("“bow”")));
    addTake("statue", {.frames = 45, .period = 1, .step = 0});
    walk().takes[1].sequence = "statue";
    EXPECT_THAT(failure(), HasSubstr("“statue”"));
}

TEST_F(MotionSpaceSteps, SayWhichParametersConflict)
{
    addTake("middle", {.period = 18, .step = 0.035, .size = 1.3});
    walk().takes.emplace_back().sequence = "middle";
    walk().parameters.emplace_back().name = "haste";
    EXPECT_THAT(failure(), HasSubstr("on one line"));
    walk().parameters.pop_back();
    walk().takes.pop_back();
    // What is slower lies where more speed is asked for.
    walk().parameters[0] = {.name = "height", .measure = SpaceMeasure::Height, .vertex = 50, .unknown = {}};
    walk().takes[0].place = {1};
    walk().takes[1].place = {0};
    EXPECT_THAT(failure(), HasSubstr("“height”"));
}

TEST_F(MotionSpaceSteps, SayWhatTheEntryLacks)
{
    const MotionSpaceEntry whole = walk();
    walk().parameters[0].measure = SpaceMeasure::Forward;
    EXPECT_THAT(failure(), HasSubstr("which vertex"));
    walk().parameters[0].vertex = 56;
    EXPECT_THAT(failure(), AllOf(HasSubstr("vertex 56"), HasSubstr("from 0 to 55")));
    walk() = whole;
    walk().takes[0].place = {1, 2};
    EXPECT_THAT(failure(), HasSubstr("another number of values"));
    walk() = whole;
    walk().parameters.clear();
    EXPECT_THAT(failure(), HasSubstr("has no parameter"));
    EXPECT_THROW(opened("run"), Error);
    walk().takes.clear();
    EXPECT_THROW(opened("walk"), Error);
}

TEST_F(MotionSpaceSteps, CanBeCancelled)
{
    const ProjectResults results({project, folder / "p.quadrille"});
    CancelToken token;
    int reports = 0;
    const Progress progress(token, [&](double) {
        if (++reports == 5)
            token.cancel();
    });
    EXPECT_THROW(openMotionSpace(results, "walk", progress), Error);
}

} // namespace quadrille
