// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "model/project/document/findentry.h"
#include "model/project/fields/references.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"
#include "tests/model/project/fullproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

/// The full project, with clips and exports of its animation and of a sequence, and a path span of a
/// sequence.
Project referringProject()
{
    Project project = fullProject();
    SequenceEntry shown = sequenceOf("shown", "clip:animations/tour");
    shown.character = "liam";
    SequenceEntry part = sequenceOf("part", "clip:sequences/shown");
    part.character = "liam";
    SequenceEntry leap = sequenceOf("leap", "fox/leap.pc2");
    leap.character = "fox";
    project.sequences.insert(project.sequences.end(), {shown, part, leap});
    for (const char* what : {"animations/tour", "sequences/part", "sequences/leap"}) {
        ExportEntry entry;
        entry.name = std::string("of ") + what;
        std::replace(entry.name.begin(), entry.name.end(), '/', ' ');
        entry.what = what;
        entry.path = "out/x.ply";
        project.exports.push_back(entry);
    }
    auto& path = std::get<PathEntry>(project.animations.front().constraints[0]);
    path.spans.push_back({.from = 2, .to = 3, .frames = FrameChoice{"", "again", {}}});
    return project;
}

std::string projectText(const Project& project)
{
    return writeJson(projectToJson(project));
}

std::vector<std::string> namesIn(const std::vector<ExportEntry>& exports)
{
    std::vector<std::string> names;
    for (const ExportEntry& entry : exports)
        names.push_back(entry.what);
    return names;
}

} // namespace

TEST(References, FollowASequenceThatGetsAnotherName)
{
    Project project = referringProject();
    project.sequences[0].source = "take_a.pc2";
    project.sequences[0].labels[0].label = "chat";
    project.sequences[0].texture = {};
    project.sequences[0].jointAngles.clear();
    project.characters[0].notes.clear();
    project.exports[0].name = "ply";
    project.exports[0].path = "a.ply";
    ASSERT_THAT(projectText(project), HasSubstr("talk"));
    renameEntry(project, NamedKind::Sequence, "talk", "speech");
    EXPECT_THAT(projectText(project), Not(HasSubstr("talk")));
    EXPECT_FALSE(hasErrors(validate(project)));
}

TEST(References, FollowAnAnimationAndACharacter)
{
    Project project = referringProject();
    const auto& files = project.sequences[0];
    project.characters[0].mesh = project.characters[0].texture.paths[0] = "a";
    project.sequences[0].source = project.sequences[0].jointAngles = "b";
    project.sequences[0].texture.paths = {"c"};
    project.animations[0].post.symmetry = project.animations[0].audio->file = "d";
    ASSERT_EQ(files.character, "liam");
    renameEntry(project, NamedKind::Animation, "tour", "trip");
    renameEntry(project, NamedKind::Character, "liam", "noah");
    project.exports[1].name = "x";
    const std::string text = projectText(project);
    EXPECT_THAT(text, Not(HasSubstr("tour")));
    EXPECT_THAT(text, Not(HasSubstr("liam")));
    EXPECT_FALSE(hasErrors(validate(project)));
    renameEntry(project, NamedKind::Animation, "trip", "tour");
    renameEntry(project, NamedKind::Character, "noah", "liam");
    EXPECT_EQ(project.sequences[4].source, "clip:animations/tour");
}

TEST(References, OfTheSameNameInOtherSectionsStay)
{
    Project project = referringProject();
    renameEntry(project, NamedKind::Animation, "tour", "talk");
    renameEntry(project, NamedKind::Sequence, "talk", "speech");
    EXPECT_EQ(project.animations.front().name, "talk");
    EXPECT_EQ(project.sequences[4].source, "clip:animations/talk");
    EXPECT_EQ(project.sequences[1].source, "clip:sequences/speech");
    EXPECT_THAT(namesIn(project.exports), ::testing::ElementsAre("sequences/speech", "animations/talk",
                                                                 "sequences/part", "sequences/leap"));
}

TEST(References, ToASequenceGoWithItAndLeaveTheRestOfAnAnimation)
{
    Project project = referringProject();
    removeEntries(project, NamedKind::Sequence, {"talk"});
    // “again” shows “talk”.
    EXPECT_THAT(namesIn(project.exports),
                ::testing::ElementsAre("animations/tour", "sequences/part", "sequences/leap"));
    ASSERT_EQ(project.animations.size(), 1U);
    const AnimationEntry& tour = project.animations.front();
    EXPECT_FALSE(tour.start);
    EXPECT_FALSE(tour.walk);
    EXPECT_TRUE(tour.junctions.isEmpty());
    EXPECT_TRUE(tour.junctions.walk.empty());
    ASSERT_EQ(tour.constraints.size(), 1U);
    EXPECT_EQ(std::get<PathEntry>(tour.constraints.front()).spans.size(), 1U);
    EXPECT_TRUE(project.evaluations.front().sequences.empty());
    EXPECT_FALSE(hasErrors(validate(project)));
}

TEST(References, OfAModelOfAppearanceGoOneByOneAndTakeItWithTheLast)
{
    Project project = fullProject();
    const std::string last = project.appearances.front().sequences.back();
    removeEntries(project, NamedKind::Sequence, {project.appearances.front().sequences.front()});
    ASSERT_EQ(project.appearances.size(), 1U);
    EXPECT_EQ(project.appearances.front().sequences, std::vector{last});
    EXPECT_FALSE(project.appearances.front().reference); // it was of the other one
    removeEntries(project, NamedKind::Sequence, {last});
    EXPECT_TRUE(project.appearances.empty()); // none would mean all
}

TEST(References, OfAMotionSpaceFollowNamesAndTakeItWithTheLast)
{
    Project project = fullProject();
    renameEntry(project, NamedKind::Sequence, "softly", "loudly");
    EXPECT_EQ(project.motionSpaces.front().takes[1].sequence, "loudly");
    EXPECT_EQ(project.motionSpaces.front().reference, "loudly");
    removeEntries(project, NamedKind::Sequence, {"loudly"});
    ASSERT_EQ(project.motionSpaces.size(), 1U);
    EXPECT_EQ(project.motionSpaces.front().takes.size(), 1U);
    EXPECT_EQ(project.motionSpaces.front().reference, "");
    removeEntries(project, NamedKind::Sequence, {"talk"});
    EXPECT_TRUE(project.motionSpaces.empty());
}

TEST(References, OfATransferFollowNamesAndTakeItAlong)
{
    Project project = fullProject();
    SequenceEntry shown = sequenceOf("shown", "clip:transfers/doubled");
    shown.character = "liam";
    project.sequences.push_back(shown);
    renameEntry(project, NamedKind::Transfer, "doubled", "twice");
    project.transfers.front().name = "twice";
    EXPECT_EQ(project.sequences.back().source, "clip:transfers/twice");
    renameEntry(project, NamedKind::Sequence, "softly", "loudly");
    EXPECT_EQ(project.transfers.front().target.sequence, "loudly");
    removeEntries(project, NamedKind::Transfer, {"twice"});
    EXPECT_TRUE(project.transfers.empty());
    EXPECT_NE(project.sequences.back().name, "shown");

    for (const char* needed : {"talk", "softly"}) {
        project = fullProject();
        removeEntries(project, NamedKind::Sequence, {needed});
        EXPECT_TRUE(project.transfers.empty()) << needed;
    }
}

TEST(References, ToATruthFollowNamesAndGoWithoutTheTransfer)
{
    Project project = fullProject();
    project.transfers.front().truth = "sequences/again";
    renameEntry(project, NamedKind::Sequence, "again", "once more");
    EXPECT_EQ(project.transfers.front().truth, "sequences/once more");
    removeEntries(project, NamedKind::Sequence, {"once more"});
    ASSERT_EQ(project.transfers.size(), 1U);
    EXPECT_EQ(project.transfers.front().truth, "");
    project.transfers.front().truth = "variations/drawn/2";
    renameEntry(project, NamedKind::Variation, "drawn", "more");
    EXPECT_EQ(project.transfers.front().truth, "variations/more/2");
}

TEST(References, OfAProjectionFollowNamesAndTakeItAlong)
{
    Project project = fullProject();
    SequenceEntry shown = sequenceOf("shown", "clip:projections/filmed");
    shown.character = "liam";
    project.sequences.push_back(shown);
    renameEntry(project, NamedKind::Projection, "filmed", "video");
    project.projections.front().name = "video";
    EXPECT_EQ(project.sequences.back().source, "clip:projections/video");
    renameEntry(project, NamedKind::Sequence, "talk", "speak");
    EXPECT_EQ(project.projections.front().clip, "sequences/speak");
    removeEntries(project, NamedKind::Sequence, {"talk"});
    removeEntries(project, NamedKind::Projection, {"video"});
    EXPECT_TRUE(project.projections.empty());
    EXPECT_NE(project.sequences.back().name, "shown");
    project = fullProject();
    removeEntries(project, NamedKind::Sequence, {"talk"});
    EXPECT_TRUE(project.projections.empty());
}

TEST(References, ToAnAnimationTakeWhatShowsIt)
{
    Project project = referringProject();
    removeEntries(project, NamedKind::Animation, {"tour"});
    EXPECT_EQ(project.sequences.size(), 5U);
    EXPECT_THAT(namesIn(project.exports), ::testing::ElementsAre("sequences/talk", "sequences/leap"));
    EXPECT_FALSE(hasErrors(validate(project)));
}

TEST(References, ToACharacterTakeAllThatIsMadeOfIt)
{
    Project project = referringProject();
    removeEntries(project, NamedKind::Character, {"liam"});
    ASSERT_EQ(project.sequences.size(), 1U);
    EXPECT_EQ(project.sequences.front().name, "leap");
    EXPECT_TRUE(project.graphs.empty());
    EXPECT_TRUE(project.animations.empty());
    EXPECT_TRUE(project.appearances.empty());
    EXPECT_TRUE(project.evaluations.empty());
    EXPECT_THAT(namesIn(project.exports), ::testing::ElementsAre("sequences/leap"));
    EXPECT_FALSE(hasErrors(validate(project)));
}

TEST(References, WithoutANameMeanTheOnlyCharacter)
{
    Project project;
    project.characters = {characterOf("liam", "m.obj")};
    project.sequences = {sequenceOf("walk", "w.pc2")};
    project.graphs.resize(1);
    removeEntries(project, NamedKind::Character, {"liam"});
    EXPECT_EQ(project, Project());
}
