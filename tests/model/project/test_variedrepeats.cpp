// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/madeclips.h"
#include "model/project/fields/references.h"
#include "model/project/json/jsontext.h"
#include "model/project/results/opencharacter.h"
#include "model/project/steps/variedrepeats.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"
#include "tests/model/codeof.h"
#include "tests/model/project/tubeproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

namespace {

/// An animation that shows frames of the calm take three times, drawn from the variations of it.
class VariedRepeatsSteps : public TubeProject
{
protected:
    VariedRepeatsSteps()
    {
        project.graphs = {GraphEntry::paper()}; // windows that its short takes have room for
        AnimationEntry animation;
        animation.name = "again";
        animation.post.steps.contacts.reset(); // a tube has no feet
        animation.walk.emplace();
        for (const FrameRange& frames : {range(2, 12), range(5, 13), range(6, 14)})
            animation.walk->spans.push_back({"calm", frames});
        animation.post.variations.emplace();
        project.animations = {animation};
    }
    static FrameRange range(int first, int last) { return {FrameIndex(first), FrameIndex(last)}; }
    AnimationEntry& animation() { return project.animations.front(); }
    std::vector<Vec3f> frames(const std::string& clip) { return loadFrames(opened(clip)); }
    std::vector<std::string> drawn()
    {
        return column<std::string>("animations/again/variations", "variation");
    }
    /// What a rebuild of the animations tells the user.
    std::string told()
    {
        std::string texts;
        for (const StepReport& step : run("animations").steps) {
            for (const Issue& issue : step.issues)
                texts += issue.toString() + "\n";
            if (step.error)
                texts += std::string(step.error->what()) + "\n";
        }
        return texts;
    }
    std::string problems()
    {
        std::string texts;
        for (const ProjectProblem& each : validate(project))
            texts += each.pointer + ": " + each.toString() + "\n";
        return texts;
    }
};

} // namespace

TEST_F(VariedRepeatsSteps, AreDrawnFromOneVariationAfterTheOther)
{
    animation().post.variations.reset();
    computed(run("animations"));
    const std::vector<Vec3f> captured = frames("animations/again");
    const auto starts = column<std::int64_t>("animations/again/walk", "shown-from");
    animation().post.variations.emplace();
    computed(run("animations"));
    const std::vector<Vec3f> varied = frames("animations/again");
    ASSERT_EQ(varied.size(), captured.size());
    EXPECT_THAT(drawn(), ElementsAre("", "variations/sway/1", "variations/sway/2"));
    EXPECT_EQ(column<std::int64_t>("animations/again/variations", "shown-from"), starts);
    EXPECT_THAT(column<std::int64_t>("animations/again/variations", "varied-first"), ElementsAre(-1, 5, 6));
    const auto names = column<std::string>("animations/again/frames", "variation");
    const std::size_t vertices = tubeRings * tubeSides;
    for (std::int64_t f = 0; f <= 10; ++f) {
        EXPECT_EQ(names[static_cast<std::size_t>(f)], "");
        for (std::size_t v = 0; v < vertices; ++v)
            EXPECT_EQ(varied[static_cast<std::size_t>(f) * vertices + v],
                      captured[static_cast<std::size_t>(f) * vertices + v]);
    }
    // A frame of the second use has the shape of the variation's: the takes are covered all over.
    // It is played in the tempo of the take.
    const std::vector<Vec3f> own = frames("variations/sway/1");
    const double place = 8.0 * static_cast<double>(own.size() / vertices - 1) / 17;
    const auto before = static_cast<std::size_t>(place);
    const auto share = static_cast<float>(place - static_cast<double>(before));
    std::vector<Vec3f> variation;
    for (std::size_t v = 0; v < vertices; ++v)
        variation.push_back((1 - share) * own[before * vertices + v] +
                            share * own[(before + 1) * vertices + v]);
    const auto at = static_cast<std::size_t>(starts[1]) + 3;
    EXPECT_EQ(names[at], "variations/sway/1");
    EXPECT_EQ(column<std::int64_t>("animations/again/frames", "source-frame")[at], 8);
    double fromTake = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        const auto length = [&](const std::vector<Vec3f>& all, std::size_t frame) {
            return (all[frame * vertices + v] - all[frame * vertices]).norm();
        };
        EXPECT_NEAR(length(varied, at), length(variation, 0), 1e-5);
        fromTake =
            std::max(fromTake, static_cast<double>(std::abs(length(varied, at) - length(captured, at))));
    }
    EXPECT_GT(fromTake, 1e-5);
}

TEST_F(VariedRepeatsSteps, MakePlayingsOfALoopDiffer)
{
    animation().walk->spans = {{"calm", range(0, 17)}};
    animation().post.steps.loop = LoopSettings();
    animation().post.steps.repeats = 4;
    EXPECT_EQ(told(), "");
    EXPECT_THAT(drawn(), ElementsAre("", "variations/sway/1", "variations/sway/2", "variations/sway/1"));
    EXPECT_THAT(column<std::int64_t>("animations/again/variations", "playing"), ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(column<std::int64_t>("animations/again/variations", "span"), Each(1));
    const std::vector<Vec3f> shown = frames("animations/again");
    const auto names = column<std::string>("animations/again/frames", "variation");
    const std::size_t each = names.size() / 4;
    const std::size_t middle = each / 2;
    EXPECT_EQ(names[middle], "");
    EXPECT_EQ(names[each + middle], "variations/sway/1");
    EXPECT_EQ(names[2 * each + middle], "variations/sway/2");
    const auto apart = [&](std::size_t a, std::size_t b) {
        const std::size_t vertices = tubeRings * tubeSides;
        float most = 0;
        for (std::size_t v = 0; v < vertices; ++v)
            most = std::max(most, (shown[a * vertices + v] - shown[b * vertices + v]).norm());
        return most;
    };
    EXPECT_GT(apart(middle, each + middle), 1e-3F);
    EXPECT_GT(apart(each + middle, 2 * each + middle), 1e-3F);
    // One that was thrown away is replaced; none are needed where the loop is played once.
    sway().samples.front().discarded = {1};
    computed(run("animations"));
    EXPECT_THAT(drawn(), ElementsAre("", "variations/sway/2", "variations/sway/2", "variations/sway/2"));
    animation().post.steps.repeats = 1;
    EXPECT_THAT(told(), HasSubstr("No captured frames are shown twice"));
}

TEST_F(VariedRepeatsSteps, AreTheSameAgain)
{
    computed(run("animations"));
    const std::vector<Vec3f> before = frames("animations/again");
    rebuild(project, folder / "p.quadrille", {.targets = {"animations"}, .jobs = 1, .force = true});
    EXPECT_TRUE(before == frames("animations/again"));
    EXPECT_TRUE(computed(run("animations")).empty());
}

TEST_F(VariedRepeatsSteps, FollowTheSamples)
{
    computed(run("animations"));
    sway().samples.front().discarded = {1};
    EXPECT_THAT(computed(run("animations")), ElementsAre("animations/again/clip"));
    EXPECT_THAT(drawn(), ElementsAre("", "variations/sway/2", "variations/sway/2"));
    sway().samples.front().seed = 9;
    EXPECT_THAT(computed(run("animations")), Contains("animations/again/clip"));
    animation().post.variations->ease = 0.4;
    EXPECT_THAT(computed(run("animations")), ElementsAre("animations/again/clip"));
}

TEST_F(VariedRepeatsSteps, NeedNoVariationsWithoutTheOption)
{
    animation().post.variations.reset();
    EXPECT_THAT(computed(run("animations")), Each(Not(HasSubstr("variations/"))));
    EXPECT_THAT(partsOfClip(project, "animations/again").variations, IsEmpty());
    animation().post.variations.emplace();
    EXPECT_EQ(partsOfClip(project, "animations/again").variations.size(), 1U);
}

TEST_F(VariedRepeatsSteps, AreExportedAndShown)
{
    project.sequences.push_back(sequenceOf("shown", "clip:animations/again"));
    ExportEntry entry;
    entry.name = "out";
    entry.what = "sequences/shown";
    entry.path = "out.pc2";
    project.exports = {entry};
    EXPECT_FALSE(hasErrors(validate(project)));
    computed(run("exports"));
    EXPECT_EQ(frames("sequences/shown"), frames("animations/again"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out.pc2"));
}

TEST_F(VariedRepeatsSteps, SayWhenThereIsNothingToDraw)
{
    EXPECT_EQ(told(), "");
    sway().samples.front().of = "wild";
    EXPECT_THAT(told(), HasSubstr("for no variation varies them: of “calm”"));
    EXPECT_EQ(problems(), "");
    sway().samples.clear();
    EXPECT_THAT(problems(), HasSubstr("/animations/0/post/variations: "));
    EXPECT_THAT(problems(), HasSubstr("no variations to draw from"));
    EXPECT_THAT(told(), HasSubstr("for no variation varies them"));
    animation().walk->spans.resize(1);
    EXPECT_THAT(told(), HasSubstr("No captured frames are shown twice"));
}

TEST_F(VariedRepeatsSteps, DoWithoutVariationsThatAreMissing)
{
    sway().limits.poseDistance = 1e-9;
    const std::string words = told();
    EXPECT_THAT(words, HasSubstr("“variations/sway/1”, “variations/sway/2” are missing."));
    EXPECT_THAT(words, HasSubstr("for no variation varies them"));
    EXPECT_THAT(drawn(), Each(IsEmpty()));
}

TEST_F(VariedRepeatsSteps, SayWhenAnotherRebuildReplacesThem)
{
    told();
    const WorkingProject working{project, folder / "p.quadrille"};
    const std::string step = clipStepOf(clipsDrawnFrom(project, animation()).back());
    const ResultStore store(cacheFolder(working.file));
    const FreshResults fresh = ProjectResults(working).get({step});
    store.save(step, "another key", Result());
    EXPECT_EQ(codeOf([&] { fresh.resultOf(step); }), ErrorCode::ResultReplaced);
    // What is in memory stays.
    const FreshResults again = ProjectResults(working).get({step});
    EXPECT_FALSE(again.resultOf(step)->arrays.empty());
    store.save(step, "another key", Result());
    EXPECT_FALSE(again.resultOf(step)->arrays.empty());
}

TEST_F(VariedRepeatsSteps, AreRefusedWhereTheyCannotBe)
{
    animation().post.variations->from = "swey";
    animation().post.variations->ease = -1;
    EXPECT_THAT(problems(), HasSubstr("/animations/0/post/variations/from: There are no variations “swey”"));
    EXPECT_THAT(problems(), HasSubstr("“sway”"));
    EXPECT_THAT(problems(), HasSubstr("/animations/0/post/variations/ease: "));
}

TEST_F(VariedRepeatsSteps, GoRoundInNoCircle)
{
    // Variations that are learned from what is drawn from them.
    project.sequences.push_back(sequenceOf("shown", "clip:animations/again"));
    sway().training.emplace_back().sequence = "shown";
    // All variations are those of captured takes.
    EXPECT_FALSE(hasErrors(validate(project)));
    EXPECT_THAT(clipsDrawnFrom(project, animation()), IsEmpty());
    animation().post.variations->from = "sway";
    EXPECT_TRUE(isMadeOfItself(project, "animations/again"));
    EXPECT_THAT(problems(), HasSubstr("The sequence is its own source: shown → again → sway/"));
}

TEST_F(VariedRepeatsSteps, FollowTheNameOfTheirVariations)
{
    animation().post.variations->from = "sway";
    renameEntry(project, NamedKind::Variation, "sway", "swing");
    EXPECT_EQ(animation().post.variations->from, "swing");
    EXPECT_EQ(problems(), "");
    removeEntries(project, NamedKind::Variation, {"swing"});
    EXPECT_FALSE(animation().post.variations.has_value());
}

TEST_F(VariedRepeatsSteps, AreLoopedAndRetimed)
{
    animation().post.steps.retime = RetimeSettings{RetimeFactor{2}};
    computed(run("animations"));
    const auto names = column<std::string>("animations/again/frames", "variation");
    EXPECT_THAT(names, Contains("variations/sway/1"));
    EXPECT_THAT(names, Contains("variations/sway/2"));
}
