// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What each setting of variations changes, and what stays.
#include "model/core/random.h"
#include "model/project/document/madeclips.h"
#include "model/project/json/jsontext.h"
#include "model/project/steps/variate.h"
#include "model/variation/selection.h"
#include "tests/model/largestdistance.h"
#include "tests/model/project/tubeproject.h"

#include <cstring>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using quadrille::test::largestDistance;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Not;

namespace {

constexpr auto alignment = "variations/sway/alignment";
constexpr auto model = "variations/sway/tip/model";
constexpr auto samples = "variations/sway/tip/samples";
constexpr auto selection = "variations/sway/selection";
constexpr auto clip = "variations/sway/1/clip";

class VariationSettings : public TubeProject
{
protected:
    /// Steps that are to be computed again after a change.
    std::vector<std::string> stale(const std::function<void()>& change)
    {
        const Project before = project;
        change();
        const RebuildReport report =
            rebuild(project, folder / "p.quadrille", {.targets = {"variations"}, .dryRun = true});
        project = before;
        std::vector<std::string> names;
        for (const StepReport& step : report.steps) {
            if (step.state == StepState::Stale)
                names.push_back(step.step);
        }
        return names;
    }
    std::vector<double> doubles(const std::string& name)
    {
        return std::get<std::vector<double>>(std::get<DataArray>(item(name).content).values);
    }
    std::vector<Vec3f> frames(const std::string& name) { return loadFrames(opened(name)); }
};

} // namespace

TEST_F(VariationSettings, OfTheMovementAlignItAnew)
{
    computed(run("variations"));
    EXPECT_TRUE(stale([] {}).empty());
    const std::vector<std::function<void()>> changes{
        [&] { sway().cycles = true; },
        [&] { sway().displacementShare = 5; },
        [&] { sway().reference = "wild"; },
        [&] {
            sway().templatePose = NamedFrame{"wild", FrameIndex(3)};
        },
        [&] {
            sway().training[0].range = FrameRange{FrameIndex(1), FrameIndex(16)};
        },
        [&] { sway().blends.emplace_back() = {.from = "calm", .to = "wild"}; },
        [&] {
            project.bodyParts[0].pose = NamedFrame{"wild", FrameIndex(3)};
        },
        [&] { project.bodyParts[0].curves[0] = tubeRing("low", 5); },
        [&] {
            project.sequences[0].contacts = {{"left", {FrameIndex(0), FrameIndex(4)}}};
        },
    };
    for (std::size_t c = 0; c < changes.size(); ++c)
        EXPECT_THAT(stale(changes[c]), Contains(alignment)) << c;
    EXPECT_TRUE(stale([&] { project.bodyParts[0].curves[0].points = {VertexIndex(48)}; }).empty());
}

TEST_F(VariationSettings, OfLearningSamplingAndJudgingLeaveWhatIsBefore)
{
    computed(run("variations"));
    const auto learning = stale([&] { sway().learning.dimensions = 2; });
    EXPECT_THAT(learning, Not(Contains(alignment)));
    EXPECT_THAT(learning, Contains(model));
    const auto chain = stale([&] { sway().chain.burnIn = 21; });
    EXPECT_THAT(chain, Not(Contains(model)));
    EXPECT_THAT(chain, Contains(samples));
    const auto weight = stale([&] {
        sway().samples[0].to = "wild";
        sway().samples[0].weight = 0.5;
    });
    EXPECT_THAT(weight, Contains(samples));
    const auto limits = stale([&] { sway().limits.skate = 9; });
    EXPECT_THAT(limits, Not(Contains(samples)));
    EXPECT_THAT(limits, Contains(selection));
    const auto draw = stale([&] { sway().draw = PoseDraw::Sample; });
    EXPECT_THAT(draw, Not(Contains(samples)));
    EXPECT_THAT(draw, Contains(selection));
    EXPECT_THAT(draw, Contains(clip));
}

TEST_F(VariationSettings, ShareOutTheVarianceOfDisplacements)
{
    const auto scale = [&] {
        computed(run("variations/sway/base/model"));
        return doubles("variations/sway/base/displacement-scale").at(0);
    };
    const double usual = scale();
    EXPECT_GT(usual, 0);
    sway().displacementShare = 24;
    EXPECT_NEAR(scale(), 2 * usual, 1e-9 * usual);
    computed(run(model));
    EXPECT_THAT(doubles("variations/sway/tip/displacement-scale"), ElementsAre(0));
}

TEST_F(VariationSettings, NameTheTakeWhoseTimingCountsAndThePoseToLieOn)
{
    sway().reference = "wild";
    computed(run(model));
    // As many rows for each take as “wild” has frames.
    EXPECT_THAT(item("variations/sway/tip/latents").shape(), ElementsAre(30, 3));
    const std::vector<double> mean = doubles("variations/sway/tip/mean");
    sway().templatePose = NamedFrame{"wild", FrameIndex(7)};
    computed(run(model));
    EXPECT_NE(doubles("variations/sway/tip/mean"), mean);
    sway().templatePose->frame = FrameIndex(15);
    const RebuildReport report = run(alignment);
    ASSERT_FALSE(report.steps.empty());
    EXPECT_THAT(report.steps.back().error->what(), ::testing::HasSubstr("“wild” has no frame 15"));
}

TEST_F(VariationSettings, MeasureInMetresWhateverTheUnit)
{
    project.settings.axes.metresPerUnit = 0.01;
    sway().extent.spread = 0; // in the take's tempo
    for (SequenceEntry& sequence : project.sequences)
        sequence.sourceAxes = CoordinateSystem{project.settings.axes.up, 0.01};
    computed(run("variations"));
    // The tube's 1.4 units are centimetres.
    for (const double coordinate : doubles("variations/sway/tip/mean"))
        EXPECT_LT(std::abs(coordinate), 0.02);
    const std::vector<Vec3f> take = frames("sequences/calm");
    EXPECT_LT(largestDistance(frames("variations/sway/1"), take), 0.5);
    EXPECT_THAT(column<double>("variations/sway/report", "mean-pose-distance"), Each(::testing::Lt(0.002)));
}

TEST_F(VariationSettings, NumberVariationsOverAllSets)
{
    sway().samples.push_back(sway().samples.front());
    sway().samples[1].of = "wild";
    sway().samples[1].count = 1;
    sway().extent.spread = 0; // in the takes' tempo
    ExportEntry entry;
    entry.name = "all";
    entry.what = "variations/sway";
    entry.path = "set/sway.npy";
    entry.fps = 12;
    project.exports = {entry};
    computed(run("exports"));
    EXPECT_THAT(column<std::int64_t>("variations/sway/report", "variation"), ElementsAre(1, 2, 3));
    EXPECT_EQ(opened("variations/sway/3").frameCount(), 15);
    const auto json = nlohmann::json::parse(textOf(folder / "set/sway.json"));
    EXPECT_EQ(json["fps"], 12);
    EXPECT_EQ(json["variations"][2]["of"], "wild");
    // The third's latents follow all candidates of the first set.
    const std::vector<double> drawn = doubles("variations/sway/tip/samples");
    const std::string latents = textOf(folder / "set/sway_tip_latents.npy");
    constexpr std::size_t size = 18 * 3;
    std::vector<double> last(size);
    ASSERT_GT(latents.size(), size * sizeof(double));
    std::memcpy(last.data(), latents.data() + latents.size() - size * sizeof(double), size * sizeof(double));
    const auto first = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(candidatesFor(2)) * size);
    EXPECT_TRUE(std::equal(last.begin(), last.end(), drawn.begin() + first));
}

TEST_F(VariationSettings, DrawThePosesThatWereJudged)
{
    sway().draw = PoseDraw::Sample;
    sway().samples[0].seed = 5;
    computed(run("variations"));
    const auto opener = std::make_shared<SequenceOpener>(project, folder.path());
    VariationWork work(opener, sway());
    std::vector<GpdmState> states;
    LatentVariation latents;
    for (const std::string part : {"base", "tip"}) {
        const std::string name = "variations/sway/" + part;
        const std::vector<double> h = doubles(name + "/hyperparameters");
        const std::vector<double> rows = doubles(name + "/latents");
        const std::vector<double> drawn = doubles(name + "/samples");
        states.push_back(
            {Eigen::Map<const RowMatrix>(rows.data(), 36, 3), {h[0], h[1], h[2], h[3], h[4], h[5], h[6]}});
        latents.emplace_back(Eigen::Map<const RowMatrix>(drawn.data(), 18, 3));
    }
    const auto learned = work.learned(states);
    VariationPoses poses = work.poses();
    poses.seed = streamSeed(5, 0);
    const Clip expected =
        makeVariation(*learned, work.subject(sway().samples[0]), latents, work.layout(), poses);
    EXPECT_EQ(frames("variations/sway/1"), expected.positions);
    EXPECT_THAT(column<std::int64_t>("variations/sway/report", "candidate"), ElementsAre(0, 1));
}

TEST_F(VariationSettings, DrawOtherPosesThanTheMean)
{
    computed(run("variations"));
    const std::vector<Vec3f> mean = frames("variations/sway/1");
    sway().draw = PoseDraw::Sample;
    computed(run("variations"));
    EXPECT_GT(largestDistance(frames("variations/sway/1"), mean), 1e-5);
}
