// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "model/project/document/madeclips.h"
#include "model/project/json/jsontext.h"
#include "model/project/steps/selectionnote.h"
#include "model/project/store/dataitem.h"
#include "tests/model/codeof.h"
#include "tests/model/project/tubeproject.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <set>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

class VariationSteps : public TubeProject
{
protected:
    std::vector<std::int64_t> shape(const std::string& name) { return item(name).shape(); }
    std::string problem(const std::string& target = "variations")
    {
        const RebuildReport report = run(target);
        for (const StepReport& step : report.steps) {
            if (step.error)
                return step.error->what();
        }
        return "none";
    }
    std::vector<Vec3f> frames(const std::string& clip) { return loadFrames(opened(clip)); }
};

} // namespace

TEST_F(VariationSteps, OfferTheDataOfEachPart)
{
    computed(run("variations"));
    const std::string base = "variations/sway/base/";
    // Rings 0 … 8 are the base's, with the overlap; its rows end with the displacements.
    EXPECT_THAT(shape(base + "training"), ElementsAre(36, 9 * tubeSides * 3 + 6));
    EXPECT_THAT(shape(base + "mean"), ElementsAre(9 * tubeSides * 3 + 6));
    EXPECT_THAT(shape(base + "latents"), ElementsAre(36, 3));
    EXPECT_THAT(shape(base + "hyperparameters"), ElementsAre(7));
    // As many candidates as may be needed, on the frames of the reference.
    EXPECT_THAT(shape(base + "samples"), ElementsAre(12, 18, 3));
    const auto spans =
        std::get<std::vector<std::int64_t>>(std::get<DataArray>(item(base + "spans").content).values);
    EXPECT_THAT(spans, ElementsAre(0, 17, 18, 35));
    const auto objective =
        std::get<std::vector<double>>(std::get<DataArray>(item(base + "objective").content).values);
    ASSERT_GT(objective.size(), 2U);
    EXPECT_LT(objective.back(), objective.front());
    // Rings 6 … 13 are the tip's; it has no displacements.
    EXPECT_THAT(shape("variations/sway/tip/training"), ElementsAre(36, 8 * tubeSides * 3));
}

TEST_F(VariationSteps, SayHowFarVariationsAreApart)
{
    sway().samples.front().count = 12;
    sway().extent.spread = 0.8;
    computed(run("variations"));
    EXPECT_THAT(column<std::string>("variations/sway/spread", "part"),
                ElementsAre("base", "tip", "whole body"));
    const auto takes = column<double>("variations/sway/spread", "takes");
    const auto ratios = column<double>("variations/sway/spread", "ratio");
    const auto variations = column<double>("variations/sway/spread", "variations");
    for (std::size_t p = 0; p < 3; ++p) {
        EXPECT_GT(takes[p], 0.001);
        EXPECT_DOUBLE_EQ(ratios[p], variations[p] / takes[p]);
    }
    // All 52 candidates, of which the first 24 were scaled to 0.8. What is learned of so few frames rounds
    // otherwise on other processors: 0.62 was seen.
    const auto drawn = column<double>("variations/sway/tip/chains", "spread");
    EXPECT_NEAR(drawn[0], 0.8, 0.25);
    EXPECT_EQ(column<std::string>("variations/sway/tip/chains", "spread-of-takes")[0], "measured");
    // Twelve of them; the base is measured after the tip was laid onto it.
    EXPECT_GT(ratios[1], 0.2);
    EXPECT_LT(ratios[1], 1.2);
    sway().extent.spread = 0.2;
    const auto names = computed(run("variations"));
    EXPECT_THAT(names, Not(Contains("variations/sway/tip/model")));
    EXPECT_LT(column<double>("variations/sway/spread", "ratio")[1], 0.5 * ratios[1]);
}

TEST_F(VariationSteps, SayHowFarModelsAreFromWhatTheyLearned)
{
    computed(run("variations/sway/tip/model"));
    const auto model = column<double>("variations/sway/tip/learning", "model-error");
    const auto principal = column<double>("variations/sway/tip/learning", "principal-components-error");
    ASSERT_EQ(model.size(), 1U);
    EXPECT_TRUE(model[0] > 0 && model[0] < 0.01) << model[0];
    EXPECT_TRUE(principal[0] > 0 && principal[0] < 0.05) << principal[0];
}

TEST_F(VariationSteps, CentreTheTrainingRows)
{
    computed(run("variations/sway/tip/model"));
    const DataItem found = item("variations/sway/tip/training");
    const auto& array = std::get<DataArray>(found.content);
    const auto& values = std::get<std::vector<double>>(array.values);
    const Eigen::Map<const RowMatrix> rows(values.data(), array.shape[0], array.shape[1]);
    EXPECT_LT(rows.colwise().mean().cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(rows.cwiseAbs().maxCoeff(), 0.01);
}

TEST_F(VariationSteps, MakeClipsInTheTimingOfWhatTheyVary)
{
    sway().samples.front().count = 6;
    computed(run("variations"));
    const MeshSequence take = opened("sequences/calm");
    const MeshSequence first = opened("variations/sway/1");
    // The other take is a sixth shorter: so lengths vary.
    std::set<std::int64_t> lengths;
    for (int number = 1; number <= 6; ++number)
        lengths.insert(opened("variations/sway/" + std::to_string(number)).frameCount());
    EXPECT_GT(lengths.size(), 1U);
    EXPECT_GE(*lengths.begin(), 13);
    EXPECT_LE(*lengths.rbegin(), 25);
    EXPECT_EQ(first.topology->vertexCount(), take.topology->vertexCount());
    const std::vector<Vec3f> one = frames("variations/sway/1");
    const std::vector<Vec3f> two = frames("variations/sway/2");
    const std::vector<Vec3f> captured = loadFrames(take);
    double between = 0;
    double fromTake = 0;
    for (std::size_t v = 0; v < std::min({one.size(), two.size(), captured.size()}); ++v) {
        between = std::max(between, static_cast<double>((one[v] - two[v]).norm()));
        fromTake = std::max(fromTake, static_cast<double>((one[v] - captured[v]).norm()));
    }
    // Different from each other, and still the movement: the tube is 1.4 m long.
    EXPECT_GT(between, 1e-4);
    EXPECT_LT(fromTake, 0.5);
    const auto sources = column<std::string>("variations/sway/1/frames", "sequence");
    EXPECT_THAT(sources, Contains("calm"));
    EXPECT_THAT(sources, Not(Contains("wild")));
}

TEST_F(VariationSteps, GiveTheSameAgainForAnyNumberOfThreads)
{
    computed(run("variations"));
    const std::vector<Vec3f> before = frames("variations/sway/2");
    rebuild(project, folder / "p.quadrille", {.targets = {"variations"}, .jobs = 1, .force = true});
    EXPECT_EQ(frames("variations/sway/2"), before);
}

TEST_F(VariationSteps, KeepModelsWhenOnlySamplesChange)
{
    computed(run("variations"));
    sway().samples.front().seed = 7;
    const auto names = computed(run("variations"));
    EXPECT_THAT(names, Contains("variations/sway/tip/samples"));
    EXPECT_THAT(names, Not(Contains("variations/sway/tip/model")));
    sway().samples.front().discarded = {1};
    EXPECT_TRUE(computed(run("variations")).empty());
    sway().learning.seed = 3;
    EXPECT_THAT(computed(run("variations/sway/tip/model")), ElementsAre("variations/sway/tip/model"));
}

TEST_F(VariationSteps, VaryBlendsOfTakes)
{
    BlendEntry blend;
    blend.from = "calm";
    blend.to = "wild";
    sway().blends = {blend};
    SamplesEntry between;
    between.of = "calm";
    between.to = "wild";
    between.weight = 0.25;
    between.count = 1;
    sway().samples = {between};
    sway().extent.spread = 0; // in the tempo of the takes
    computed(run("variations"));
    EXPECT_THAT(shape("variations/sway/tip/latents"), ElementsAre(54, 3));
    // A quarter of the way from 18 frames to 15.
    EXPECT_NEAR(static_cast<double>(opened("variations/sway/1").frameCount()), 17.25, 0.8);
    const auto lambda = column<double>("variations/sway/1/frames", "lambda");
    EXPECT_NEAR(lambda[lambda.size() / 2], 0.25, 1e-12);
}

TEST_F(VariationSteps, AreSourcesOfSequencesAndExports)
{
    project.sequences.push_back(sequenceOf("again", "clip:variations/sway/2"));
    ExportEntry entry;
    entry.name = "again";
    entry.what = "sequences/again";
    entry.path = "again.pc2";
    project.exports = {entry};
    EXPECT_FALSE(hasErrors(validate(project)));
    computed(run("exports"));
    EXPECT_TRUE(std::filesystem::exists(folder / "again.pc2"));
    EXPECT_EQ(frames("sequences/again"), frames("variations/sway/2"));
}

TEST_F(VariationSteps, CannotLearnFromThemselves)
{
    project.sequences.push_back(sequenceOf("again", "clip:variations/sway/2"));
    sway().training.emplace_back().sequence = "again";
    std::string texts;
    for (const ProjectProblem& each : validate(project))
        texts += each.toString();
    EXPECT_THAT(texts, HasSubstr("its own source"));
}

TEST_F(VariationSteps, AreWrittenAsDataSetsWithoutTheDiscarded)
{
    sway().samples.front().count = 3;
    sway().samples.front().discarded = {2};
    ExportEntry entry;
    entry.name = "all";
    entry.what = "variations/sway";
    entry.path = "set/sway.npy";
    project.exports = {entry};
    computed(run("exports"));
    EXPECT_TRUE(std::filesystem::exists(folder / "set/sway_1.npy"));
    EXPECT_FALSE(std::filesystem::exists(folder / "set/sway_2.npy"));
    EXPECT_TRUE(std::filesystem::exists(folder / "set/sway_3.npy"));
    EXPECT_TRUE(std::filesystem::exists(folder / "set/sway_tip_latents.npy"));
    const auto json = nlohmann::json::parse(textOf(folder / "set/sway.json"));
    ASSERT_EQ(json["variations"].size(), 2U);
    EXPECT_EQ(json["variations"][1]["variation"], 3);
    EXPECT_EQ(json["variations"][1]["file"], "sway_3.npy");
    EXPECT_EQ(json["variations"][1]["of"], "calm");
    EXPECT_EQ(json["variations"][1]["frames"]["source-frame"].size(),
              static_cast<std::size_t>(opened("variations/sway/3").frameCount()));
    EXPECT_EQ(json["latents"]["tip"], "sway_tip_latents.npy");
}

TEST_F(VariationSteps, AreDiscardedByTheirNumberInTheirSet)
{
    sway().samples.push_back(sway().samples.front());
    sway().samples[1].discarded = {1};
    EXPECT_FALSE(isDiscarded(sway(), 1));
    EXPECT_TRUE(isDiscarded(sway(), 3));
    EXPECT_FALSE(isDiscarded(sway(), 4));
    EXPECT_FALSE(isDiscarded(sway(), 5));
}

TEST_F(VariationSteps, RejectWhatIsBadAndDoWithoutIt)
{
    sway().limits.poseDistance = 1e-9;
    const RebuildReport report = run("variations");
    std::string told;
    for (const StepReport& step : report.steps) {
        EXPECT_FALSE(step.error) << step.step << ": " << step.error->what();
        for (const Issue& issue : step.issues)
            told += issue.toString() + "\n";
    }
    EXPECT_THAT(told, HasSubstr("Only 0 of 2 variations of “calm” were good enough"));
    EXPECT_THAT(told, HasSubstr("12 were rejected: poses unlike all that were learned (12)"));
    EXPECT_EQ(codeOf([&] { opened("variations/sway/1"); }), ErrorCode::VariationMissing);
    // A data set holds what there is.
    ExportEntry entry;
    entry.name = "all";
    entry.what = "variations/sway";
    entry.path = "set/sway.npy";
    project.exports = {entry};
    EXPECT_EQ(problem("exports"), "none");
    EXPECT_TRUE(std::filesystem::exists(folder / "set/sway.json"));
    const auto faults = column<std::string>("variations/sway/report", "faults");
    ASSERT_EQ(faults.size(), 12U);
    EXPECT_THAT(faults, Contains(HasSubstr("pose-distance")));
}

TEST(SelectionNote, NamesTakesWithoutACycle)
{
    Movement movement;
    const auto add = [&](std::string name, TakeUse use) {
        movement.alignment.takes.push_back(
            {.name = std::move(name), .warp = {}, .poses = {}, .placements = {}});
        movement.alignment.reports.push_back({.use = use});
    };
    add("walk", TakeUse::Cycle);
    add("jog", TakeUse::Given);
    EXPECT_FALSE(noteOnCycles(movement));
    add("turn", TakeUse::NoCycle);
    add("hop", TakeUse::TooShort);
    EXPECT_THAT(noteOnCycles(movement).value(),
                HasSubstr("No cycle like that of “walk” was found in “turn”, “hop”: all frames"));
    for (WarpReport& report : movement.alignment.reports)
        report.use = TakeUse::Whole;
    EXPECT_FALSE(noteOnCycles(movement));
}

TEST_F(VariationSteps, SayWhatIsWrongWithTheirTakesAndCurves)
{
    project.bodyParts.front().curves[0].curve.vertices[3] = VertexIndex(5000);
    EXPECT_THAT(problem(), HasSubstr("low"));
    project.bodyParts.front().curves[0] = tubeRing("low", 6);
    project.bodyParts.front().curves[0].curve.vertices.pop_back();
    EXPECT_THAT(problem(), HasSubstr("low"));
    project.bodyParts.front().curves[0] = tubeRing("low", 6);
    write("short", 3, 0.05);
    project.sequences.push_back(sequenceOf("short", "short"));
    sway().training[1].sequence = "short";
    EXPECT_THAT(problem(), HasSubstr("short"));
}

TEST_F(VariationSteps, LearnFromTakesThatStandStill)
{
    for (const char* take : {"calm", "wild"}) {
        for (int f = 0; f < 18; ++f)
            folder.write(take + ("/f_" + std::to_string(100 + f)) + ".obj", bentTube(0, 0.05));
    }
    EXPECT_EQ(problem(), "none");
}

TEST_F(VariationSteps, AreRefusedWhereTheProjectAsksForTheImpossible)
{
    sway().samples.front().to = "wild";
    sway().samples.front().weight = 1.5;
    sway().learning.dimensions = 0;
    sway().training.push_back(sway().training.front());
    sway().reference = "jump";
    sway().extent = {.spread = -1, .uncertainty = 1.5};
    std::string texts;
    for (const ProjectProblem& each : validate(project))
        texts += each.pointer + ": " + each.toString() + "\n";
    for (const char* expected :
         {"/variations/0/samples/0/weight: The weight of a blend must be from 0 to 1",
          "/variations/0/learning/dimensions: ", "/variations/0/sequences/2: The take “calm” is here twice",
          "/variations/0/reference: “jump” is none of the takes",
          "/variations/0/sampling/spread: The spread must be", "/variations/0/sampling/uncertainty: "})
        EXPECT_THAT(texts, HasSubstr(expected));
}

TEST_F(VariationSteps, CompareModelsWithPrincipalComponents)
{
    EvaluationEntry evaluation;
    evaluation.table = "cvs-fig4";
    project.evaluations = {evaluation};
    computed(run("evaluations"));
    EXPECT_THAT(column<std::string>("evaluation/cvs-fig4", "part"), ElementsAre("base", "tip"));
    const auto model = column<double>("evaluation/cvs-fig4", "model-error");
    const auto principal = column<double>("evaluation/cvs-fig4", "principal-components-error");
    const auto ratio = column<double>("evaluation/cvs-fig4", "ratio");
    for (std::size_t p = 0; p < 2; ++p) {
        const std::string part = p == 0 ? "base" : "tip";
        EXPECT_GT(model[p], 0);
        EXPECT_LT(model[p], 0.5 * principal[p]) << part;
        EXPECT_DOUBLE_EQ(ratio[p], model[p] / principal[p]);
        computed(run("variations/sway/" + part + "/model"));
        EXPECT_EQ(model[p], column<double>("variations/sway/" + part + "/learning", "model-error")[0]);
    }
}

TEST_F(VariationSteps, AreMeasuredBesideTheirTakes)
{
    EvaluationEntry evaluation;
    evaluation.table = "variations";
    project.evaluations = {evaluation};
    sway().extent.spread = 0;
    computed(run("evaluations"));
    const auto value = [this](const std::string& name) {
        return column<double>("evaluation/variations", name).at(0);
    };
    EXPECT_THAT(column<std::int64_t>("evaluation/variations", "asked"), ElementsAre(2));
    EXPECT_THAT(column<std::int64_t>("evaluation/variations", "delivered"), ElementsAre(2));
    EXPECT_THAT(column<std::int64_t>("evaluation/variations", "rejected-collapse"), ElementsAre(0));
    // Without a spread they repeat the take as far as the model knows it.
    EXPECT_NEAR(value("acceleration"), 1, 0.2);
    EXPECT_LT(value("sink"), 0.005);
    EXPECT_LT(value("heading"), 2);
    EXPECT_EQ(value("length-spread"), 0);
}
