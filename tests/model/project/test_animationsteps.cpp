// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "model/project/document/findentry.h"
#include "model/project/exports/exportentry.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/media.h"
#include "model/project/store/clipresult.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/audio/tone.h"
#include "tests/model/project/stripproject.h"

#include <cmath>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

namespace {

WalkSpanEntry spanOf(std::string sequence, std::int64_t first, std::int64_t last)
{
    return {std::move(sequence), {FrameIndex(first), FrameIndex(last)}};
}

/// An animation with a hand-written walk from the slow sequence to the quick one.
class AnimationSteps : public StripProject
{
protected:
    AnimationSteps()
    {
        project.graphs.resize(1);
        AnimationEntry animation;
        animation.name = "dance";
        animation.walk = WalkEntry{.spans = {spanOf("slow", 0, 5), spanOf("quick", 4, 8)}};
        project.animations = {animation};
    }
    AnimationEntry& animation() { return project.animations.front(); }
    std::string problem()
    {
        const RebuildReport report = run("animations");
        for (const StepReport& step : report.steps) {
            if (step.error)
                return step.error->what();
        }
        return "none";
    }
    MeshSequence opened(const std::string& clip)
    {
        SequenceOpener opener(project, folder.path(), cacheFolder(folder / "p.quadrille"));
        return opener.openClip(clip)->sequence;
    }
};

} // namespace

TEST_F(AnimationSteps, ShowTheWalkWithTheOriginOfEachFrame)
{
    computed(run("animations"));
    using Texts = std::vector<std::string>;
    const Texts sequences = column<std::string>("animations/dance/frames", "sequence");
    const auto source = column<std::int64_t>("animations/dance/frames", "source-frame");
    const auto lambda = column<double>("animations/dance/frames", "lambda");
    const auto length = column<std::int64_t>("animations/dance/walk", "transition-length").front();
    ASSERT_EQ(static_cast<std::int64_t>(sequences.size()), 6 + 5 + length - 2);
    for (std::size_t f = 0; f < 6; ++f) {
        EXPECT_EQ(sequences[f], "slow");
        EXPECT_EQ(source[f], static_cast<std::int64_t>(f));
        EXPECT_EQ(lambda[f], 0);
    }
    for (std::size_t f = 6; f + 5 < lambda.size(); ++f)
        EXPECT_TRUE(lambda[f] > 0 && lambda[f] < 1);
    EXPECT_EQ(source.back(), 8);
    EXPECT_EQ(sequences.back(), "quick");
    EXPECT_THAT(column<std::int64_t>("animations/dance/walk", "shown-from"), ElementsAre(0, 4 + length));
}

TEST_F(AnimationSteps, BeginWhereTheWalkSaysAndTurnedSo)
{
    computed(run("animations"));
    const MeshSequence plain = opened("animations/dance");
    animation().walk->turn = 90;
    animation().walk->at = Vec2d(10, 20);
    computed(run("animations"));
    const MeshSequence placed = opened("animations/dance");
    const auto x = column<double>("animations/dance/frames", "centre-x");
    const auto z = column<double>("animations/dance/frames", "centre-z");
    EXPECT_NEAR(x[0], 10, 1e-5);
    EXPECT_NEAR(z[0], 20, 1e-5);
    const auto side = [](const MeshSequence& sequence) -> Vec3f {
        const Frame frame = sequence.frame(FrameIndex(0));
        return frame.positions()[8] - frame.positions()[0];
    };
    // A quarter turn about y takes x to −z.
    EXPECT_NEAR(side(placed).z(), -side(plain).x(), 1e-5);
    EXPECT_NEAR(side(placed).x(), side(plain).z(), 1e-5);
}

TEST_F(AnimationSteps, MeetKeysAndSayWhen)
{
    animation().walk.reset();
    KeyEntry first;
    first.sequence = "slow";
    first.frame = FrameIndex(1);
    KeyEntry second = first;
    second.frame = FrameIndex(7);
    second.time = 1; // six frames
    animation().constraints = {first, second};
    computed(run("animations"));
    EXPECT_EQ(column<std::int64_t>("animations/dance/frames", "source-frame"),
              (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7}));
    const auto what = column<std::string>("animations/dance/report", "what");
    const auto wanted = column<double>("animations/dance/report", "wanted");
    const auto obtained = column<double>("animations/dance/report", "obtained");
    ASSERT_EQ(what.size(), wanted.size());
    ASSERT_EQ(what.size(), obtained.size());
    std::vector<double> keys;
    for (std::size_t row = 0; row < what.size(); ++row) {
        if (what[row] == "key")
            keys.push_back(obtained[row]);
        else
            EXPECT_TRUE(std::isnan(wanted[row])) << what[row]; // nothing was asked, which tables leave empty
    }
    EXPECT_THAT(keys, ElementsAre(0, 1));
}

TEST_F(AnimationSteps, PerformActionsByTheirLabels)
{
    project.sequences[0].labels = {{"sway", {FrameIndex(2), FrameIndex(9)}}};
    animation().walk.reset();
    ActionEntry action;
    action.frames.label = "sway";
    animation().constraints = {action};
    computed(run("animations"));
    const auto frames = column<std::int64_t>("animations/dance/frames", "source-frame");
    EXPECT_GE(frames.front(), 2);
    EXPECT_LE(frames.back(), 9);
    // Labels are part of what a walk depends on.
    project.sequences[0].labels[0].frames.last = FrameIndex(5);
    EXPECT_THAT(computed(run("animations")), ::testing::Contains("animations/dance/walk"));
}

TEST_F(AnimationSteps, FollowAPathAndSayHowWell)
{
    for (int f = 0; f < 14; ++f)
        folder.write("gone/f_" + std::to_string(f) + ".obj", bentStrip(0.3 * std::sin(0.35 * f), 0.2 * f));
    project.sequences.push_back(sequenceOf("gone", "gone"));
    animation().walk.reset();
    PathEntry path;
    path.curve = PathCurve::Polyline;
    path.points = {{0, 0, 0}, {1.5, 0, 0}};
    animation().constraints = {path};
    computed(run("animations"));
    const auto x = column<double>("animations/dance/frames", "centre-x");
    EXPECT_NEAR(x.front(), 0, 0.2);
    EXPECT_GT(x.back(), 1.2);
    EXPECT_THAT(column<std::string>("animations/dance/report", "what"),
                ::testing::Contains("mean deviation"));
}

TEST_F(AnimationSteps, SayWhatStandsInTheWayOfConstraints)
{
    animation().walk.reset();
    KeyEntry key;
    key.sequence = "slow";
    key.frame = FrameIndex(1);
    key.time = 0;
    KeyEntry unreachable = key;
    unreachable.sequence = "quick";
    unreachable.frame = FrameIndex(0); // no transition arrives there
    unreachable.time = 2;
    animation().constraints = {key, unreachable};
    EXPECT_THAT(problem(), HasSubstr("no walk leads to frame 0 of “quick”"));
}

TEST_F(AnimationSteps, ArePostProcessed)
{
    computed(run("animations"));
    const std::int64_t plain = opened("animations/dance").frameCount();
    animation().post.steps.retime = RetimeSettings{RetimeFactor{2}};
    computed(run("animations"));
    EXPECT_EQ(opened("animations/dance").frameCount(), 2 * plain - 1);
    animation().post.steps.retime.reset();
    animation().walk = WalkEntry{.spans = {spanOf("slow", 0, 13)}};
    animation().post.steps.loop.emplace();
    computed(run("animations"));
    const std::int64_t once = opened("animations/dance").frameCount();
    EXPECT_EQ(std::get<DataArray>(item("animations/dance/loop-travel").content).shape.front(), 3);
    animation().post.steps.repeats = 3;
    EXPECT_THAT(computed(run("animations")), UnorderedElementsAre("animations/dance/clip"));
    EXPECT_EQ(opened("animations/dance").frameCount(), 3 * once);
}

TEST_F(AnimationSteps, AreMirroredByTheSymmetryThatAFileNames)
{
    animation().post.steps.mirror = true;
    animation().post.symmetry = "opposite.csv";
    folder.write("opposite.csv", "1,0,3,2,5,4,7,6,9,9\n");
    EXPECT_THAT(problem(), HasSubstr("opposite.csv"));
}

TEST_F(AnimationSteps, OnlyWhatASettingReachesIsComputedAgain)
{
    computed(run("animations"));
    EXPECT_TRUE(computed(run("animations")).empty());
    animation().interpolation = InterpolationMethod::Linear;
    EXPECT_THAT(computed(run("animations")), UnorderedElementsAre("animations/dance/clip"));
    animation().walk->spans.back().frames.last = FrameIndex(7);
    EXPECT_THAT(computed(run("animations")),
                UnorderedElementsAre("animations/dance/walk", "animations/dance/clip"));
}

TEST_F(AnimationSteps, AreExportedAsEverySequenceIs)
{
    ExportEntry entry;
    entry.name = "cache";
    entry.what = "animations/dance";
    entry.path = "dance.pc2";
    project.exports = {entry};
    EXPECT_THAT(computed(run("exports")), ::testing::Contains("animations/dance/clip"));
    const std::string bytes = textOf(folder / "dance.pc2");
    EXPECT_FALSE(bytes.empty());
    std::filesystem::remove_all(cacheFolder(folder / "p.quadrille"));
    computed(run("exports"));
    EXPECT_TRUE(bytes == textOf(folder / "dance.pc2"));
}

TEST_F(AnimationSteps, AreSourcesOfSequences)
{
    SequenceEntry again = sequenceOf("again", "clip:animations/dance");
    again.range = FrameRange{FrameIndex(2), FrameIndex(6)};
    again.labels = {{"cut", {FrameIndex(0), FrameIndex(4)}}};
    project.sequences.push_back(again);
    project.sequences.push_back(sequenceOf("once-more", "clip:sequences/again"));
    ASSERT_FALSE(hasErrors(validate(project)));
    const auto steps = computed(run("sequences"));
    EXPECT_THAT(steps, ::testing::Contains("sequences/once-more/statistics"));
    EXPECT_EQ(opened("sequences/once-more").frameCount(), 5);
    const Frame shown = opened("sequences/once-more").frame(FrameIndex(1));
    const Frame made = opened("animations/dance").frame(FrameIndex(3));
    EXPECT_TRUE(shown.positions()[3] == made.positions()[3]);
    // They are not of the graph that they are made from.
    EXPECT_EQ(matrix("pose-distance").rows(), 23);
    computed(run("frames"));
    EXPECT_EQ(column<std::string>("frames", "sequence").size(), 23U);
}

TEST_F(AnimationSteps, CannotBeMadeOfThemselves)
{
    project.sequences.push_back(sequenceOf("again", "clip:animations/dance"));
    animation().walk->spans.push_back(spanOf("again", 0, 3));
    const ProjectProblems problems = validate(project);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().pointer, "/animations/0/walk/spans/2/sequence");
    EXPECT_THAT(problems.front().toString(), HasSubstr("is itself made from this graph"));
    animation().junctions.walk.push_back(animation().walk->spans.back());
    animation().walk->spans.pop_back();
    ASSERT_EQ(validate(project).size(), 1U);
    EXPECT_EQ(validate(project).front().pointer, "/animations/0/junctions/walk/0/sequence");
}

TEST_F(AnimationSteps, GoRoundInNoCircleThroughTwoCharacters)
{
    project.characters = {characterOf("a", "slow/f_0.obj"), characterOf("b", "slow/f_0.obj")};
    for (SequenceEntry& sequence : project.sequences)
        sequence.character = "a";
    project.graphs = {GraphEntry{.character = "a"}, GraphEntry{.character = "b"}};
    animation().character = "a";
    SequenceEntry ofB = sequenceOf("of-b", "clip:animations/dance");
    ofB.character = "b";
    AnimationEntry back;
    back.name = "back";
    back.character = "b";
    back.walk = WalkEntry{.spans = {spanOf("of-b", 0, 5)}};
    project.sequences.push_back(ofB);
    project.animations.push_back(back);
    ASSERT_FALSE(hasErrors(validate(project)));
    computed(run("animations"));
    EXPECT_EQ(opened("animations/back").frameCount(), 6);

    SequenceEntry ofA = sequenceOf("of-a", "clip:animations/back");
    ofA.character = "a";
    project.sequences.push_back(ofA);
    const ProjectProblems problems = validate(project);
    ASSERT_FALSE(problems.empty());
    EXPECT_THAT(problems.front().toString(), HasSubstr("is its own source"));
}

TEST_F(AnimationSteps, SayWhichFrameOrTransitionAWalkCannotHave)
{
    animation().walk->spans[1] = spanOf("quick", 4, 30);
    EXPECT_THAT(problem(), HasSubstr("“quick” has no frame 30"));
    animation().walk->spans[1] = spanOf("quick", 0, 8); // no window fits before its first frame
    EXPECT_THAT(problem(), HasSubstr("no transition from frame 5 of “slow” to frame 0 of “quick”"));
}

TEST_F(AnimationSteps, ThatAreNotComputedSaySo)
{
    project.sequences.push_back(sequenceOf("again", "clip:animations/dance"));
    try {
        opened("sequences/again");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("not computed yet"));
    }
}

TEST_F(AnimationSteps, SayWhatAnUnfinishedAnimationLacks)
{
    animation().walk.reset();
    EXPECT_THAT(problem(), HasSubstr("“dance” asks for nothing"));
    ActionEntry action;
    action.frames.label = "kick";
    animation().constraints = {action};
    EXPECT_THAT(problem(), HasSubstr("No sequence has the label “kick”"));
    EXPECT_FALSE(hasErrors(validate(project))); // it can be opened and mended
}

TEST_F(AnimationSteps, TakeSoundAndCameraIntoVideosWithoutMakingTheClipAgain)
{
    folder.write("tone.wav", wavOf(tone(0.5)));
    ExportEntry video;
    video.name = "film";
    video.what = "animations/dance";
    video.path = "film.mp4";
    video.picture = UnknownKeys({{"width", 64}, {"height", 48}});
    project.exports = {video};
    computed(run("exports"));
    const std::string plain = textOf(folder / "film.mp4");
    EXPECT_THAT(computed(run("exports")), ElementsAre());

    animation().audio = AudioEntry{.file = "tone.wav", .offset = 0.25};
    EXPECT_THAT(computed(run("exports")), ElementsAre("exports/film"));
    const std::string loud = textOf(folder / "film.mp4");
    EXPECT_THAT(loud, HasSubstr("soun"));
    EXPECT_THAT(plain, ::testing::Not(HasSubstr("soun")));

    // Another sound under the same name is another film.
    folder.write("tone.wav", wavOf(tone(0.25)));
    EXPECT_THAT(computed(run("exports")), ElementsAre("exports/film"));
    EXPECT_NE(textOf(folder / "film.mp4"), loud);

    animation().camera = {{.key = {.time = 0, .target = {2, 0, 0.5}, .distance = 8}}};
    EXPECT_THAT(computed(run("exports")), ElementsAre("exports/film"));
    // An export that says itself what the camera does follows no keys.
    project.exports.front().picture.set("camera", "fixed");
    EXPECT_TRUE(cameraKeysOf(project, project.exports.front()).empty());
    computed(run("exports"));
    animation().camera.front().key.distance = 9;
    EXPECT_THAT(computed(run("exports")), ElementsAre());
}

TEST_F(AnimationSteps, StartSoundAndCameraWithTheFramesThatAreWritten)
{
    ExportEntry pictures;
    pictures.name = "pictures";
    pictures.what = "animations/dance";
    pictures.path = "out/p.png";
    pictures.picture = UnknownKeys({{"width", 64}, {"height", 48}});
    CameraKey still{.time = 0, .target = {2, 0, 0.5}, .distance = 8};
    animation().camera = {{.key = still}, {.key = {.time = 0.5, .target = {2, 0, 0.5}, .distance = 2}}};
    ExportEntry part = pictures;
    part.name = "part";
    part.path = "out/q.png";
    part.range = FrameRange{FrameIndex(3), FrameIndex(4)}; // 0.5 s
    project.exports = {pictures, part};
    computed(run("exports"));
    EXPECT_EQ(textOf(folder / "out/p_0003.png"), textOf(folder / "out/q_0000.png"));
    EXPECT_NE(textOf(folder / "out/p_0000.png"), textOf(folder / "out/q_0000.png"));
}

TEST_F(AnimationSteps, MissASoundThatIsNotThere)
{
    animation().audio = AudioEntry{.file = "none.wav"};
    const auto media = mediaOf(project, folder.path());
    ASSERT_EQ(std::count_if(media.begin(), media.end(), [](const MediaUse& use) { return !use.exists; }), 1);
    EXPECT_EQ(media.back().pointer, "/animations/0/audio/file");
    EXPECT_EQ(media.back().owner, "animations/dance");
}

TEST_F(AnimationSteps, NameWhatIsWrongWithACamera)
{
    animation().camera = {{.key = {.time = 1}}, {.key = {.time = 1}}};
    const auto problems = validate(project);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().pointer, "/animations/0/camera/1/time");
}
