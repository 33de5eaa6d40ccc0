// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/checks/validate.h"
#include "tests/model/project/lookproject.h"

#include <gmock/gmock.h>
#include <numeric>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

namespace {

constexpr double nothing = 0; ///< is lost

double meanOf(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The pattern moves in each texture: a warp tells what many Eigen textures do not.
class AppearanceEvaluations : public LookProject
{
protected:
    AppearanceEvaluations() { look().components = 10; }

    void evaluate(std::initializer_list<const char*> tables)
    {
        for (const char* table : tables)
            project.evaluations.emplace_back().table = table;
    }
    /// From six textures, for what holds of any number.
    void learnFromFew()
    {
        for (SequenceEntry& sequence : project.sequences)
            sequence.range = FrameRange{FrameIndex(0), FrameIndex(2)};
    }
    RebuildReport run() { return StripProject::run("evaluations"); }
    std::vector<double> values(const std::string& table, const std::string& column)
    {
        return this->column<double>("evaluation/" + table, column);
    }
};

} // namespace

TEST_F(AppearanceEvaluations, Fig17And18ShowWhatComponentsRestore)
{
    evaluate({"fig17", "fig18"});
    for (EvaluationEntry& entry : project.evaluations)
        entry.count = 2;
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("appearance/look/model", "evaluations/fig17", "evaluations/fig18"));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig17", "components"), ElementsAre(1, 2, 5, 10, 20, 22));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig17", "warps"), ElementsAre(0, 1, 2, 3, 7, 7));
    for (const std::string domain : {"texture", "image"}) {
        const auto naive = values("fig18", domain + "_mse_naive");
        EXPECT_TRUE(std::ranges::is_sorted(naive, std::greater())) << "errors do not grow";
        EXPECT_EQ(naive.back(), nothing) << "all components are the textures themselves";
        EXPECT_GT(values("fig17", domain + "_ssim_naive").back(), 0.9999);
        const auto own = values("fig18", domain + "_mse");
        EXPECT_EQ(own[0], naive[0]) << "one component is no warp";
        EXPECT_LT(own[1], 0.85 * naive[1]) << "one that is tells more than an Eigen texture";
        EXPECT_LT(own[2], 0.5 * own[0]);
        EXPECT_GT(values("fig17", domain + "_ssim")[1], values("fig17", domain + "_ssim_naive")[1]);
        EXPECT_GT(values("fig17", domain + "_ssim").back(), 0.97);
    }
    EXPECT_THAT(column<std::string>("evaluation/fig17-crossover", "domain"), ElementsAre("texture", "image"));
    for (const double crossing : values("fig18-crossover", "components")) {
        EXPECT_GT(crossing, 2);
        EXPECT_LE(crossing, 22);
    }
    // As the model itself has it, but for bytes.
    const double stored = meanOf(column<double>("appearance/look/metrics", "mean-squared-error"));
    EXPECT_NEAR(values("fig18", "texture_mse")[3], stored, 0.1 * stored + 0.1);
}

TEST_F(AppearanceEvaluations, WithoutAShareOfWarpsBothWaysAreOne)
{
    learnFromFew();
    look().warpShare = 0;
    evaluate({"fig17", "fig19"});
    for (EvaluationEntry& entry : project.evaluations)
        entry.count = 1;
    run();
    for (const char* table : {"fig17", "fig19"}) {
        EXPECT_EQ(values(table, "texture_ssim"), values(table, "texture_ssim_naive"));
        EXPECT_EQ(values(table, "image_ssim"), values(table, "image_ssim_naive"));
    }
    EXPECT_THAT(column<std::int64_t>("evaluation/fig17", "warps"), Each(0));
}

TEST_F(AppearanceEvaluations, Fig19And20ShowWhatIsMadeOfTexturesLeftOut)
{
    evaluate({"fig19", "fig20"});
    for (EvaluationEntry& entry : project.evaluations)
        entry.count = 2;
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("appearance/look/model", "evaluations/fig19", "evaluations/fig20"));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig19", "training"), ElementsAre(1, 2, 5, 7, 9, 12, 14));
    EXPECT_THAT(column<std::int64_t>("evaluation/fig19", "draws"), Each(2));
    for (const std::string domain : {"texture", "image"}) {
        const auto own = values("fig20", domain + "_mse");
        const auto naive = values("fig20", domain + "_mse_naive");
        EXPECT_LT(own.back(), 0.5 * own.front()) << "more is learned from more";
        EXPECT_LT(naive.back(), 0.5 * naive.front());
        EXPECT_LT(own[2], naive[2]) << "motion is learned from few textures";
        EXPECT_GT(values("fig19", domain + "_ssim")[2], values("fig19", domain + "_ssim_naive")[2]);
        EXPECT_GT(values("fig19", domain + "_ssim_deviation")[0], 0);
    }
}

TEST_F(AppearanceEvaluations, Fig19IsDrawnByItsSeedWhateverTheNumberOfThreads)
{
    learnFromFew();
    evaluate({"fig19"});
    project.evaluations[0].count = 1;
    run();
    const auto before = values("fig19", "texture_ssim");
    project.evaluations[0].seed = 2;
    EXPECT_THAT(computed(run()), ElementsAre("evaluations/fig19"));
    EXPECT_NE(values("fig19", "texture_ssim"), before);
    project.evaluations[0].seed = 1;
    rebuild(project, projectFile(), {.targets = {"evaluations"}, .jobs = 1, .force = true});
    EXPECT_EQ(values("fig19", "texture_ssim"), before) << "the same seed, another number of threads";
}

TEST_F(AppearanceEvaluations, Fig22ComparesBlendsWithThoseOfAllEigenTextures)
{
    evaluate({"fig22"});
    project.evaluations[0].count = 5;
    run();
    EXPECT_THAT(column<std::int64_t>("evaluation/fig22", "textures"), ElementsAre(1, 2, 5, 10, 20, 22));
    const auto errors = values("fig22", "mse");
    EXPECT_EQ(errors.back(), nothing);
    EXPECT_GT(values("fig22", "ssim").back(), 0.9999);
    EXPECT_GT(errors[0], 0);
    EXPECT_LE(errors[3], errors[0]);
}

TEST_F(AppearanceEvaluations, BlendsByTheModelComeNearerToWhatWasCapturedBetween)
{
    evaluate({"appearance-interpolation"});
    run();
    EXPECT_THAT(column<std::int64_t>("evaluation/appearance-interpolation", "apart"), ElementsAre(1, 2, 4));
    EXPECT_THAT(column<std::int64_t>("evaluation/appearance-interpolation", "frames"),
                ElementsAre(12 + 7, 10 + 5, 6 + 1));
    const auto linear = values("appearance-interpolation", "rms_linear");
    const auto own = values("appearance-interpolation", "rms");
    EXPECT_LT(own[1], linear[1]);
    EXPECT_LT(own[2], 0.9 * linear[2]);
    EXPECT_NEAR(values("appearance-interpolation", "rms_ratio")[2], own[2] / linear[2], 1e-12);
    EXPECT_GT(values("appearance-interpolation", "ssim")[2],
              values("appearance-interpolation", "ssim_linear")[2]);
    EXPECT_NEAR(meanOf(values("appearance-interpolation-frames", "rms")),
                (19 * own[0] + 15 * own[1] + 7 * own[2]) / 41, 1e-9);
    project.evaluations[0].count = 2;
    run();
    EXPECT_THAT(column<std::int64_t>("evaluation/appearance-interpolation", "frames"), ElementsAre(2, 2, 2));
}

TEST_F(AppearanceEvaluations, ShapesSayWhatPosesTellOfTexturesOfATakeLeftOut)
{
    evaluate({"appearance-shape"});
    EXPECT_THAT(computed(run()),
                UnorderedElementsAre("appearance/look/model", "evaluations/appearance-shape"));
    const std::string table = "evaluation/appearance-shape";
    EXPECT_THAT(column<std::string>(table, "take"), ElementsAre("slow", "quick"));
    EXPECT_THAT(column<std::int64_t>(table, "frames"), ElementsAre(slowFrames, quickFrames));
    for (std::size_t take = 0; take < 2; ++take) {
        const auto at = [&](const std::string& name) { return values("appearance-shape", name)[take]; };
        EXPECT_LT(at("warp_rms_learned"), 0.5 * at("warp_rms_mean")) << "the pattern moves with the pose";
        EXPECT_LT(at("warp_rms_nearest"), at("warp_rms_mean"));
        EXPECT_GT(at("ssim_learned"), at("ssim_mean"));
        EXPECT_LT(at("mse_learned"), 0.5 * at("mse_mean"));
        EXPECT_GT(at("rms_nearest"), 0);
    }
    const auto before = values("appearance-shape", "mse_learned");
    rebuild(project, projectFile(), {.targets = {"evaluations"}, .jobs = 1, .force = true});
    EXPECT_EQ(values("appearance-shape", "mse_learned"), before) << "another number of threads";
    project.sequences.pop_back();
    EXPECT_THAT(failure("evaluations")->what(), HasSubstr("learns from one take alone"));
}

TEST_F(AppearanceEvaluations, RatesSayWhatFilesTakeAndLose)
{
    evaluate({"appearance-rates"});
    run();
    const auto kinds = column<std::string>("evaluation/appearance-rates", "kind");
    const auto bytes = column<std::int64_t>("evaluation/appearance-rates", "bytes");
    const auto perFrame = values("appearance-rates", "bytes_per_frame");
    const auto similarity = values("appearance-rates", "ssim");
    EXPECT_EQ(kinds.front(), "captured");
    std::uintmax_t captured = 0;
    for (int f = 0; f < slowFrames; ++f)
        captured += std::filesystem::file_size(textureFile("slow", f));
    for (int f = 0; f < quickFrames; ++f)
        captured += std::filesystem::file_size(textureFile("quick", f));
    EXPECT_EQ(static_cast<std::uintmax_t>(bytes.front()), captured);
    for (const char* kind : {"model", "jpeg", "h264"})
        EXPECT_GE(std::ranges::count(kinds, kind), 3) << kind;
    for (std::size_t row = 1; row < kinds.size(); ++row) {
        EXPECT_DOUBLE_EQ(perFrame[row], static_cast<double>(bytes[row]) / (slowFrames + quickFrames));
        if (kinds[row] != kinds[row - 1])
            continue;
        EXPECT_GT(bytes[row], bytes[row - 1]) << kinds[row];
        EXPECT_GT(similarity[row], similarity[row - 1] - 0.01) << kinds[row];
    }
    EXPECT_GT(similarity.back(), 0.9) << "the finest film";
    EXPECT_FALSE(std::filesystem::exists(filesOfLook() / "rates.h5"));
    const auto least = column<std::string>("evaluation/appearance-rates-least", "least");
    for (std::size_t row = 0; row < least.size(); ++row) {
        for (const char* kind : {"model", "jpeg", "h264"}) {
            const double other = values("appearance-rates-least", kind)[row];
            EXPECT_FALSE(!least[row].empty() && other < values("appearance-rates-least", least[row])[row]);
        }
    }
}

TEST_F(AppearanceEvaluations, TooFewTexturesAreRefused)
{
    for (SequenceEntry& sequence : project.sequences)
        sequence.range = FrameRange{FrameIndex(0), FrameIndex(0)};
    for (const char* table : {"fig17", "fig20", "fig22", "appearance-interpolation", "appearance-rates"}) {
        project.evaluations.clear();
        evaluate({table});
        const auto error = failure("evaluations");
        ASSERT_TRUE(error) << table;
        EXPECT_EQ(error->code(), ErrorCode::ProjectInvalid);
        EXPECT_THAT(error->what(), HasSubstr("learns from 2 textures")) << table;
    }
}

TEST_F(AppearanceEvaluations, WithoutAModelThereIsNothingToEvaluate)
{
    evaluate({"fig17"});
    project.appearances.clear();
    const ProjectProblems problems = validate(project);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems.front().severity, ProjectProblem::Severity::Warning);
    EXPECT_EQ(problems.front().pointer, "/evaluations/0");
    EXPECT_THROW(run(), Error) << "as any other target that is not there";
}
