// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "model/project/document/entryname.h"
#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"
#include "model/project/document/problemtexts.h"
#include "model/project/json/jsontext.h"
#include "tests/model/project/fullproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

std::string onlyProblem(const Project& project)
{
    const auto problems = validate(project);
    EXPECT_EQ(problems.size(), 1U) << (problems.size() > 1 ? problems[1].toString() : "");
    return problems.empty() ? "" : problems[0].pointer + " " + problems[0].toString();
}

} // namespace

TEST(Validate, AFullProjectHasNoProblems)
{
    EXPECT_TRUE(validate(fullProject()).empty());
}

TEST(Validate, TheCharacterMayBeLeftOutOnlyWhereThereIsOne)
{
    Project project;
    project.characters = {characterOf("a", "a.obj")};
    project.sequences = {sequenceOf("s", "s.pc2")};
    EXPECT_TRUE(validate(project).empty());
    project.characters.push_back(characterOf("b", "b.obj"));
    EXPECT_THAT(onlyProblem(project), HasSubstr("“character” is missing"));
    project.sequences[0].character = "c";
    EXPECT_THAT(onlyProblem(project), HasSubstr("no character “c”"));
    project.characters[0].name = "dancer";
    project.sequences[0].character = "dacner";
    EXPECT_THAT(onlyProblem(project), HasSubstr("Did you mean “dancer”?"));
}

TEST(Validate, TransfersAreChecked)
{
    const auto problemOf = [](auto change) {
        Project project = fullProject();
        change(project.transfers[0]);
        return onlyProblem(project);
    };
    using Entry = TransferEntry;
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "sequences/takl"; }),
                AllOf(HasSubstr("/transfers/0/clip"), HasSubstr("Did you mean “talk”?")));
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "transfers/double"; }), HasSubstr("There is no transfer"));
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "transfers/doubled"; }), HasSubstr("made of itself"));
    EXPECT_THAT(problemOf([](Entry& e) { e.target.sequence = "x"; }),
                HasSubstr("/transfers/0/target/sequence"));
    EXPECT_THAT(problemOf([](Entry& e) { e.reference->frame = FrameIndex(-1); }),
                HasSubstr("/transfers/0/reference/frame"));
    EXPECT_THAT(problemOf([](Entry& e) { e.pairs[1].onTarget = e.pairs[0].onTarget; }),
                AllOf(HasSubstr("/transfers/0/pairs/1"), HasSubstr("in two pairs")));
    EXPECT_THAT(problemOf([](Entry& e) { e.scale = 0; }), HasSubstr("/transfers/0/scale"));
    EXPECT_THAT(problemOf([](Entry& e) { e.truth = "sequences/sotfly"; }),
                AllOf(HasSubstr("/transfers/0/truth"), HasSubstr("Did you mean “softly”?")));
    EXPECT_THAT(problemOf([](Entry& e) { e.truth = "softly"; }), HasSubstr("names no clip"));
}

TEST(Validate, MotionSpacesAreChecked)
{
    const auto problemOf = [](auto change) {
        Project project = fullProject();
        change(project.motionSpaces[0]);
        return onlyProblem(project);
    };
    using Entry = MotionSpaceEntry;
    EXPECT_THAT(problemOf([](Entry& e) { e.takes[0].sequence = "takl"; }),
                AllOf(HasSubstr("/motion_spaces/0/takes/0"), HasSubstr("Did you mean “talk”?")));
    EXPECT_THAT(problemOf([](Entry& e) { e.takes.resize(9, e.takes[1]); }), HasSubstr("at most 8 takes"));
    EXPECT_THAT(problemOf([](Entry& e) { e.takes[0].speed = 0; }),
                HasSubstr("/motion_spaces/0/takes/0/speed"));
    EXPECT_THAT(problemOf([](Entry& e) {
                    e.takes[0].place = {1, 2};
                }),
                AllOf(HasSubstr("/motion_spaces/0/takes/0/place"), HasSubstr("another number of values")));
    EXPECT_THAT(problemOf([](Entry& e) { e.parameters.clear(), e.takes[0].place.clear(); }),
                HasSubstr("differ in"));
    EXPECT_THAT(problemOf([](Entry& e) { e.takes.erase(e.takes.begin()); }), HasSubstr("needs 2 takes"));
    EXPECT_THAT(problemOf([](Entry& e) { e.parameters[0].vertex.reset(); }), HasSubstr("which vertex"));
    EXPECT_THAT(problemOf([](Entry& e) { e.parameters[0].measure = SpaceMeasure::Speed; }),
                HasSubstr("measures no vertex"));
    EXPECT_THAT(problemOf([](Entry& e) {
                    e.parameters[0].vertex.reset();
                    e.parameters[0].measure = SpaceMeasure::ByHand;
                }),
                AllOf(HasSubstr("“softly” has no place"), HasSubstr("“left hand”")));
    EXPECT_THAT(problemOf([](Entry& e) { e.reference = "tlak"; }), HasSubstr("none of the takes"));
    EXPECT_THAT(problemOf([](Entry& e) { e.tolerance = 0; }), HasSubstr("/motion_spaces/0/tolerance"));
    EXPECT_THAT(problemOf([](Entry& e) {
                    for (const char* name : {"b", "c", "d"})
                        e.parameters.emplace_back().name = name;
                    e.takes[0].place.assign(4, 0);
                }),
                HasSubstr("at most 3"));
}

TEST(Validate, ProjectionsAreChecked)
{
    const auto problemOf = [](auto change) {
        Project project = fullProject();
        change(project.projections[0]);
        return onlyProblem(project);
    };
    using Entry = ProjectionEntry;
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "sequences/takl"; }),
                AllOf(HasSubstr("/projections/0/clip"), HasSubstr("Did you mean “talk”?")));
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "projections/film"; }),
                HasSubstr("There is no projection"));
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "projections/filmed"; }), HasSubstr("made of itself"));
    EXPECT_THAT(problemOf([](Entry& e) { e.clip = "variations/softer"; }), HasSubstr("/projections/0/clip"));
    EXPECT_THAT(problemOf([](Entry& e) { e.size = 15; }), HasSubstr("/projections/0/size"));
    EXPECT_THAT(problemOf([](Entry& e) { e.sharpness = 17; }), HasSubstr("/projections/0/sharpness"));
    // Two of which each shows the other.
    Project project = fullProject();
    project.projections.push_back(project.projections[0]);
    project.projections[1].name = "again";
    project.projections[0].clip = "projections/again";
    project.projections[1].clip = "projections/filmed";
    EXPECT_EQ(validate(project).size(), 2U);
}

TEST(Validate, ModelsOfAppearanceAreChecked)
{
    const auto problemOf = [](auto change) {
        Project project = fullProject();
        change(project.appearances[0]);
        return onlyProblem(project);
    };
    using Entry = AppearanceEntry;
    EXPECT_THAT(problemOf([](Entry& e) { e.components = 0; }), HasSubstr("/appearance/0/components"));
    EXPECT_THAT(problemOf([](Entry& e) { e.warpShare = 1.1; }), HasSubstr("/appearance/0/warp_share"));
    EXPECT_THAT(problemOf([](Entry& e) { e.sequences[1] = "softy"; }),
                AllOf(HasSubstr("/appearance/0/sequences/1"), HasSubstr("Did you mean “softly”?")));
    EXPECT_THAT(problemOf([](Entry& e) { e.sequences[1] = "talk"; }), HasSubstr("twice"));
    EXPECT_THAT(problemOf([](Entry& e) { e.reference->sequence = "x"; }),
                HasSubstr("/appearance/0/reference/sequence"));
    EXPECT_THAT(problemOf([](Entry& e) { e.reference->frame = FrameIndex(-1); }),
                HasSubstr("/appearance/0/reference/frame"));
    EXPECT_THAT(problemOf([](Entry& e) { e.completions[0].frame.sequence = "x"; }),
                HasSubstr("/appearance/0/completions/0/frame/sequence"));
    EXPECT_THAT(problemOf([](Entry& e) { e.completions[0].strokes[0].points.pop_back(); }),
                HasSubstr("/completions/0/strokes/0/points"));
    EXPECT_THAT(problemOf([](Entry& e) { e.completions[0].strokes[0].radius = 0; }),
                HasSubstr("/completions/0/strokes/0/radius"));
}

TEST(Validate, GraphsAreChecked)
{
    const auto problemOf = [](auto change) {
        Project project;
        project.characters = {characterOf("a", "a.obj")};
        project.graphs.resize(1);
        change(project.graphs[0]);
        return onlyProblem(project);
    };
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.alpha = -0.01; }), HasSubstr("/graph/alpha"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.alpha = std::nan(""); }), HasSubstr("/graph/alpha"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.slope = 6; }), HasSubstr("/graph/slope"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.durations = {2, 1}; }), HasSubstr("/graph/durations"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.durations = {0, 1}; }), HasSubstr("/graph/durations"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.greatestDistance = 0; }), HasSubstr("/graph/d_max"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.pose.stretchWeight = -1; }),
                HasSubstr("/graph/stretch_weight"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.pose.triangles = 0; }), HasSubstr("/graph/triangles"));
    EXPECT_THAT(problemOf([](GraphEntry& g) { g.character = "b"; }), HasSubstr("no character “b”"));
    Project project = fullProject();
    project.graphs.push_back(project.graphs[0]);
    EXPECT_THAT(onlyProblem(project), HasSubstr("two graphs of one character"));
    project.graphs[1].character.clear();
    EXPECT_THAT(onlyProblem(project), HasSubstr("“character” is missing"));
}

TEST(Validate, EvaluationsAreChecked)
{
    Project project = fullProject();
    project.evaluations[0].table = "fig77";
    EXPECT_THAT(onlyProblem(project), AllOf(HasSubstr("/evaluations/0"), HasSubstr("Did you mean “fig7”?")));
    project.evaluations[0].table = "scatter";
    EXPECT_THAT(onlyProblem(project), HasSubstr("Write one of “fig4”, “fig7”, “fig9”"));
    project = fullProject();
    project.evaluations[0].alphas = {0.1, -0.1};
    EXPECT_THAT(onlyProblem(project), HasSubstr("/evaluations/0/alphas"));
    project = fullProject();
    project.evaluations[0].table = "table1";
    project.evaluations[0].sequences.clear();
    EXPECT_TRUE(validate(project).empty());
    project.evaluations[0].character = "fox";
    EXPECT_THAT(onlyProblem(project), HasSubstr("No sequence has reference joint angles"));
    project.evaluations[0].character.clear();
    project.sequences[0].jointAngles.clear();
    EXPECT_THAT(onlyProblem(project), HasSubstr("No sequence has reference joint angles"));
    project = fullProject();
    project.evaluations[0].count = 0;
    EXPECT_THAT(onlyProblem(project), HasSubstr("/evaluations/0/count"));
    project = fullProject();
    project.evaluations[0].seed = -1;
    EXPECT_THAT(onlyProblem(project), HasSubstr("/evaluations/0/seed"));
    project = fullProject();
    project.evaluations[0].sequences = {"talk"};
    EXPECT_THAT(onlyProblem(project), HasSubstr("Two sequences are needed"));
    project.evaluations[0].sequences = {"talk", "agian"};
    EXPECT_THAT(onlyProblem(project), AllOf(HasSubstr("/sequences/1"), HasSubstr("Did you mean “again”?")));
    project = fullProject();
    project.evaluations[0].sequences.clear();
    project.evaluations[0].character = "lima";
    EXPECT_THAT(onlyProblem(project), HasSubstr("Did you mean “liam”?"));
    project = fullProject();
    project.evaluations.push_back(project.evaluations[0]);
    EXPECT_THAT(onlyProblem(project), HasSubstr("here twice"));
    project.evaluations[1].character.clear();
    EXPECT_TRUE(validate(project).empty());
}

TEST(Validate, CyclesOfClipsAreRefused)
{
    Project project;
    project.sequences = {sequenceOf("a", "clip:sequences/b"), sequenceOf("b", "clip:sequences/c"),
                         sequenceOf("c", "clip:sequences/b"), sequenceOf("d", "clip:sequences/d")};
    const auto problems = validate(project);
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_EQ(problems[0].pointer, "/sequences/1/source");
    EXPECT_THAT(problems[0].toString(), HasSubstr("b → c → b"));
    EXPECT_EQ(problems[1].pointer, "/sequences/2/source");
    EXPECT_EQ(problems[2].pointer, "/sequences/3/source");
}

TEST(Validate, ClipsOfSectionsThatAreNotKnownAreNoError)
{
    Project project;
    project.sequences = {sequenceOf("a", "clip:motion_spaces/dance")};
    EXPECT_THAT(onlyProblem(project), HasSubstr("no section “motion_spaces”"));
    project.unknown.set("motion_spaces", Json::array());
    EXPECT_THAT(onlyProblem(project), HasSubstr("cannot be used by this version"));
    EXPECT_FALSE(hasErrors(validate(project)));
}

TEST(Validate, PathsThatHoldOnOneMachineOnlyAreWarnings)
{
    Project project;
    project.sequences = {sequenceOf("a", "C:\\takes\\a.pc2"), sequenceOf("b", "/takes/b.pc2")};
    const auto problems = validate(project);
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_FALSE(hasErrors(problems));
    EXPECT_THAT(problems[0].toString(), HasSubstr("backslashes"));
    EXPECT_THAT(problems[1].toString(), HasSubstr("this machine only"));
}

TEST(Validate, NamesAndPathsFitTheNamesOfFiles)
{
    EXPECT_EQ(problemWithName(std::string(longestName, 'a')), std::nullopt);
    EXPECT_THAT(problemWithName(std::string(longestName + 1, 'a')).value_or(""), HasSubstr("too long"));
    std::string accents;
    for (std::size_t i = 0; i <= longestName / 2; ++i)
        accents += "é"; // two bytes each
    EXPECT_THAT(problemWithName(accents).value_or(""), HasSubstr("too long"));
    Project project;
    project.sequences = {sequenceOf("a", "takes/" + std::string(256, 'b') + ".pc2")};
    EXPECT_THAT(onlyProblem(project),
                AllOf(HasSubstr("/sequences/0/source"), HasSubstr("more than 255 bytes")));
}

TEST(Validate, NumbersThatSizeMemoryAndTimeHaveLimits)
{
    using Change = std::function<void(AnimationEntry&)>;
    const std::vector<std::pair<Change, const char*>> changes{
        {[](AnimationEntry& entry) { entry.constraints = {KeyEntry{.sequence = "a", .time = 1e5}}; },
         "/constraints/0/time"},
        {[](AnimationEntry& entry) {
             entry.constraints = {ActionEntry{.frames = {.sequence = "a"}, .repeat = 1001}};
         },
         "/constraints/0/repeat"},
        {[](AnimationEntry& entry) {
             entry.constraints = {ActionEntry{.frames = {.sequence = "a"}, .duration = 3601}};
         },
         "/constraints/0/duration"},
        {[](AnimationEntry& entry) {
             entry.constraints = {PathEntry{.points = {Vec3d(0, 0, 0), Vec3d(1e6, 0, 0)}}};
         },
         "/constraints/0/points/1"},
        {[](AnimationEntry& entry) { entry.search.budget = 2'000'000'000; }, "/search/budget"},
        {[](AnimationEntry& entry) {
             entry.post.steps.loop = LoopSettings();
             entry.post.steps.repeats = 1'000'000;
         },
         "/post/repeats"},
        {[](AnimationEntry& entry) { entry.post.steps.retime = RetimeSettings{.time = RetimeFactor{1e6}}; },
         "/post/retime/factor"},
        {[](AnimationEntry& entry) { entry.post.steps.retime = RetimeSettings{.time = Seconds{1e5}}; },
         "/post/retime/duration"}};
    for (const auto& [change, place] : changes) {
        Project project;
        project.sequences = {sequenceOf("a", "a.pc2")};
        AnimationEntry animation{.name = "dance"};
        animation.constraints = {KeyEntry{.sequence = "a"}};
        change(animation);
        project.animations = {animation};
        EXPECT_THAT(onlyProblem(project), HasSubstr(std::string("/animations/0") + place));
        EXPECT_TRUE(hasErrors(validate(project))) << place;
    }
    Project project;
    project.settings.fps = 1e-6;
    EXPECT_THAT(onlyProblem(project), HasSubstr("/settings/fps"));
    project = {};
    project.graphs.emplace_back().durations = {1, 1e5};
    EXPECT_THAT(onlyProblem(project), HasSubstr("/durations"));
    project = fullProject();
    project.variations.front().learning.greatestIterations = 2'000'000'000;
    EXPECT_THAT(onlyProblem(project), HasSubstr("/learning/iterations"));
}

TEST(Validate, APartNamesTwoDifferentCurves)
{
    Project project = fullProject();
    auto& curves = project.bodyParts.front().parts[1].part.curves;
    curves[1] = curves[0];
    EXPECT_THAT(onlyProblem(project),
                HasSubstr("/body_parts/0/parts/1/curves/1 The part “arm” names the curve “shoulder” twice"));
}

TEST(Paths, AreStoredRelativeWithForwardSlashes)
{
    const TemporaryFolder folder;
    EXPECT_EQ(storedPath(folder / "takes/a.pc2", folder.path()), "takes/a.pc2");
    EXPECT_EQ(storedPath(folder / "a.pc2", folder / "projects"), "../a.pc2");
    EXPECT_EQ(resolvePath("../a.pc2", folder / "projects").lexically_normal(), folder / "a.pc2");
    EXPECT_EQ(resolvePath("/a.pc2", folder.path()), fs::path("/a.pc2"));
    EXPECT_EQ(resolvePath("", folder.path()), fs::path());
}

TEST(Paths, LeadOutOfAFolderThatIsALink)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "deep/er/project");
    fs::create_directory_symlink(folder / "deep/er/project", folder / "link");
    folder.write("deep/er/a.pc2", "x");
    const std::string stored = storedPath(folder / "deep/er/a.pc2", folder / "link");
    EXPECT_TRUE(fs::exists(resolvePath(stored, folder / "link"))) << stored;
}

TEST(ClosestWord, FindsSlipsAndNothingFarFetched)
{
    constexpr std::array<std::string_view, 4> known{"source", "source_fps", "per_frame", "variations"};
    EXPECT_EQ(closestWord("sorce", known), "source");
    EXPECT_EQ(closestWord("Source-FPS", known), "source_fps");
    EXPECT_EQ(closestWord("transfers", known), std::nullopt);
    EXPECT_EQ(closestWord("colour", known), std::nullopt);
}
