// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/live/bakedplayer.h"
#include "model/project/checks/validate.h"
#include "model/project/document/findentry.h"
#include "model/project/results/openlive.h"
#include "model/project/steps/livework.h"
#include "tests/model/project/walkproject.h"

#include <gmock/gmock.h>

namespace quadrille {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Walks by speed, and stands as one take alone: a performance that goes from the one to the other.
class LiveSteps : public test::WalkProject
{
protected:
    LiveSteps()
    {
        project.motionSpaces.push_back(spaceOf("steady", {"slow"}));
        LiveEntry entry;
        entry.name = "stroll";
        entry.spaces = {"walk", "steady"};
        entry.inputs = {{0, {.space = 0, .parameters = {0.8}}},
                        {41, {.space = 1}},
                        {120, {.space = 0, .parameters = {1}, .isResponsive = true}}};
        entry.ticks = 200;
        project.lives = {entry};
    }
    LiveEntry& stroll() { return project.lives.front(); }
    SequenceOpener opener() { return {project, folder.path(), cacheFolder(folder / "p.quadrille")}; }
    std::vector<Vec3f> positions()
    {
        SequenceOpener opened = opener();
        return loadFrames(opened.openClip("live/stroll")->sequence);
    }
    std::string problem()
    {
        const ProjectProblems problems = validate(project);
        return problems.empty() ? "" : problems.front().toString();
    }
};

} // namespace

TEST_F(LiveSteps, MakeAClipWithItsReport)
{
    EXPECT_EQ(failure("live"), "");
    SequenceOpener opened = opener();
    const MeshSequence clip = opened.openClip("live/stroll")->sequence;
    EXPECT_EQ(clip.frameCount(), 101);
    EXPECT_EQ(clip.fps, 25);
    EXPECT_THAT(column<std::string>("live/stroll/transitions", "from"), ElementsAre("walk", "steady"));
    EXPECT_THAT(column<std::string>("live/stroll/transitions", "to"), ElementsAre("steady", "walk"));
    EXPECT_THAT(column<std::int64_t>("live/stroll/transitions", "tick"), ElementsAre(42, 121));
    EXPECT_THAT(column<std::int64_t>("live/stroll/transitions", "wished"), ElementsAre(42, 121));
    EXPECT_EQ(column<std::int64_t>("live/stroll/report", "tick").back(), 200);
    EXPECT_THAT(column<std::string>("live/stroll/frames", "sequence"),
                ::testing::Each(::testing::AnyOf("slow", "fast")));
}

TEST_F(LiveSteps, SayBetweenWhichTexturesEachFrameLies)
{
    run("live");
    const auto weights = column<double>("live/stroll/textures", "lambda");
    ASSERT_EQ(weights.size(), 101U);
    EXPECT_THAT(weights, ::testing::Each(::testing::AllOf(::testing::Ge(0), ::testing::Le(0.5))));
    EXPECT_GT(weights.front(), 0); // walking at a speed between those of the takes
    EXPECT_EQ(column<std::string>("live/stroll/textures", "sequence").front(), "fast");
    EXPECT_EQ(column<std::string>("live/stroll/textures", "destination-sequence").front(), "slow");
    EXPECT_EQ(weights[50], 0); // one take alone
    SequenceOpener opened = opener();
    const MeshSequence clip = opened.openClip("live/stroll")->sequence;
    EXPECT_EQ(clip.frameCount(), 101);
}

TEST_F(LiveSteps, MakeTheSameBytesAgain)
{
    run("live");
    const std::vector<Vec3f> first = positions();
    std::filesystem::remove_all(cacheFolder(folder / "p.quadrille"));
    run("live");
    EXPECT_EQ(positions(), first);
    EXPECT_THAT(computed(run("live")), IsEmpty());
}

TEST_F(LiveSteps, MakeWhatAPlayerPlays)
{
    stroll().correctsContacts = false;
    run("live");
    const OpenedLiveGraphPointer graph =
        openLiveGraph(ProjectResults({project, folder / "p.quadrille"}),
                      characterNameOf(project, project.motionSpaces.front()));
    EXPECT_THAT(graph->spaces, ElementsAre("walk", "steady"));
    LivePlayer player(graph->graph, settingsOf(stroll()), startOf(stroll(), project.settings.axes));
    std::vector<Vec3f> played;
    std::vector<Vec3f> pose(graph->graph->vertexCount());
    perform(player, inputsOf(stroll()), [&](LivePlayer& each) {
        if (each.state().tick % 2 != 0)
            return;
        each.pose(pose);
        played.insert(played.end(), pose.begin(), pose.end());
    });
    EXPECT_EQ(positions(), played);
}

TEST_F(LiveSteps, AreExportedAsPlayers)
{
    stroll().correctsContacts = false;
    stroll().from = 40;
    ExportEntry entry;
    entry.name = "game";
    entry.what = "live/stroll";
    entry.path = "stroll.qplayer";
    project.exports = {entry};
    ASSERT_EQ(failure("exports"), "");
    const BakedPlayer baked = readBakedPlayer(folder / "stroll.qplayer");
    LivePlayer player(baked.graph, baked.settings, baked.start);
    std::vector<Vec3f> played;
    std::vector<Vec3f> pose(baked.graph->vertexCount());
    perform(player, baked.inputs, [&](LivePlayer& each) {
        const std::int64_t tick = each.state().tick - baked.from;
        if (tick < 0 || tick % baked.settings.ticksPerFrame != 0)
            return;
        each.pose(pose);
        played.insert(played.end(), pose.begin(), pose.end());
    });
    EXPECT_EQ(positions(), played);
    EXPECT_EQ(baked.frameOf({.space = 1, .take = 0, .frame = 3}).sequence, "slow");
    EXPECT_THAT(computed(run("exports")), IsEmpty());
    stroll().inputs[0].input.parameters = {0.9};
    EXPECT_THAT(computed(run("exports")), ElementsAre("live/stroll/clip", "exports/game"));
}

TEST_F(LiveSteps, AreNotExportedAsPlayersOfWhatPlayersHaveNot)
{
    ExportEntry entry;
    entry.name = "game";
    entry.what = "sequences/slow";
    entry.path = "slow.qplayer";
    project.exports = {entry};
    EXPECT_THAT(failure("exports"), HasSubstr("only the motion spaces of a performance"));
    project.exports[0].what = "live/stroll";
    project.exports[0].fps = 50;
    EXPECT_THAT(failure("exports"), HasSubstr("no range, no rate and no axes"));
}

TEST_F(LiveSteps, BeginTheClipWhereItIsWanted)
{
    stroll().correctsContacts = false;
    run("live");
    const std::vector<Vec3f> all = positions();
    stroll().from = 100;
    run("live");
    const std::vector<Vec3f> end = positions();
    ASSERT_LT(end.size(), all.size());
    EXPECT_TRUE(std::equal(end.rbegin(), end.rend(), all.rbegin()));
    stroll().from = 0;
    stroll().position = Vec2d(3, 2);
    run("live");
    EXPECT_GT((positions().front() - all.front()).norm(), 3);
}

TEST_F(LiveSteps, BecomeTakesOfTheirOwn)
{
    project.sequences.push_back(test::sequenceOf("again", "clip:live/stroll"));
    EXPECT_EQ(problem(), "");
    run("live");
    SequenceOpener opened = opener();
    EXPECT_EQ(opened.open("again")->sequence.frameCount(), 101);
}

TEST_F(LiveSteps, SayWhatIsWrong)
{
    const LiveEntry good = stroll();
    stroll().spaces = {"walk", "jog"};
    EXPECT_THAT(problem(), HasSubstr("There is no motion space “jog”"));
    stroll() = good;
    stroll().spaces = {"walk"};
    EXPECT_THAT(problem(), HasSubstr("There is no space 1"));
    stroll() = good;
    stroll().inputs[2].tick = 41;
    EXPECT_THAT(problem(), HasSubstr("must ascend"));
    stroll() = good;
    stroll().inputs[0].tick = 3;
    EXPECT_THAT(problem(), HasSubstr("must ascend"));
    stroll() = good;
    stroll().from = 201;
    EXPECT_THAT(problem(), HasSubstr("after the end"));
}

TEST(LiveChanges, AreInputsThatDiffer)
{
    LiveEntry entry;
    entry.ticks = 10;
    entry.inputs = {
        {0, {.space = 0, .parameters = {1}}}, {4, {.space = 0, .parameters = {2}}}, {9, {.space = 1}}};
    const std::vector<LiveInput> inputs = inputsOf(entry);
    ASSERT_EQ(inputs.size(), 10U);
    EXPECT_EQ(inputs[3].parameters[0], 1);
    EXPECT_EQ(inputs[4].parameters[0], 2);
    EXPECT_EQ(inputs[9].space, 1U);
    EXPECT_EQ(changesOf(inputs), entry.inputs);
}

} // namespace quadrille
