// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/appearancefile.h"
#include "model/appearance/texturequality.h"
#include "model/project/steps/appearancework.h"
#include "tests/model/markedpng.h"
#include "tests/model/project/lookproject.h"

#include <chrono>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

namespace {

constexpr int left = 26; ///< of a square of 12² texels that is not known
constexpr int side = 12;

bool isInSquare(int x, int y)
{
    return x >= left && x < left + side && y >= left && y < left + side;
}

/// The square in white, or as a colour of its own in a picture.
Image squareIn(Image image, std::uint8_t grey)
{
    for (int y = left; y < left + side; ++y) {
        for (int x = left; x < left + side; ++x)
            std::fill_n(image.pixel(x, y), 3, grey);
    }
    return image;
}

double similarityInSquare(const Image& reference, const Image& picture)
{
    std::vector<std::uint8_t> mask;
    for (int y = 0; y < reference.height; ++y) {
        for (int x = 0; x < reference.width; ++x)
            mask.push_back(isInSquare(x, y) ? 1 : 0);
    }
    return pictureQuality(reference, picture, mask).similarity;
}

class AppearanceSteps : public LookProject
{
protected:
    std::vector<fs::path> flows() const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(filesOfLook() / "flows"))
            files.push_back(entry.path());
        std::ranges::sort(files);
        return files;
    }
    /// Makes all flows old, so that those can be told that are written again.
    void age() const
    {
        for (const fs::path& file : flows())
            fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(5));
    }
    std::vector<fs::path> writtenAgain() const
    {
        std::vector<fs::path> files = flows();
        std::erase_if(files, [](const fs::path& file) {
            return fs::last_write_time(file) < fs::file_time_type::clock::now() - std::chrono::hours(4);
        });
        return files;
    }
    void completeSlow(int frame)
    {
        CompletionEntry completion;
        completion.frame = {"slow", FrameIndex(frame)};
        completion.mask = "mask.png";
        writeImage(squareIn(Image(64, 64), 255), folder / "mask.png");
        writeImage(squareIn(slowPattern(frame), 0), textureFile("slow", frame));
        look().completions = {completion};
    }
    std::shared_ptr<const OpenedSequence> opened(const std::string& sequence)
    {
        return SequenceOpener(project, folder.path(), results()).open(sequence);
    }
    static CapturedTexture capturedAt(const MeshSequence& sequence, int frame)
    {
        return {sequence.name, FrameIndex(frame),
                sequence.textures.textures().at(static_cast<std::size_t>(frame))};
    }
};

} // namespace

TEST_F(AppearanceSteps, MakeAModelOfAllTexturesOfACharacter)
{
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model"));
    std::vector<std::string> names;
    for (const DataItem& item : projectData(project, projectFile())) {
        if (item.name.starts_with("appearance/"))
            names.push_back(item.name);
    }
    EXPECT_THAT(names, IsSupersetOf({"appearance/look/eigenvalues", "appearance/look/warp-eigenvalues",
                                     "appearance/look/coefficients", "appearance/look/warp-coefficients",
                                     "appearance/look/reference", "appearance/look/frames",
                                     "appearance/look/metrics"}));
    const std::string prefix = "appearance/look/";
    constexpr std::int64_t all = slowFrames + quickFrames;
    EXPECT_THAT(item(prefix + "coefficients").shape(), ElementsAre(all, 6));
    EXPECT_THAT(item(prefix + "warp-coefficients").shape(), ElementsAre(all, 3));
    EXPECT_EQ(column<std::string>(prefix + "frames", "sequence").back(), "quick");
    EXPECT_EQ(column<std::int64_t>(prefix + "frames", "row").back(), all - 1);
    for (const double similarity : column<double>(prefix + "metrics", "similarity"))
        EXPECT_GT(similarity, 0.95);
    // A pattern that moves along one line is one Eigen warp and no Eigen texture to speak of.
    const auto values =
        std::get<std::vector<double>>(std::get<DataArray>(item(prefix + "warp-eigenvalues").content).values);
    EXPECT_GT(values[0], 10 * values[1]);
}

TEST_F(AppearanceSteps, OfferWhatLiesInTheModelsFile)
{
    const std::string prefix = "appearance/look/";
    run("appearance");
    const AppearanceModel model = readAppearanceFile(filesOfLook() / "model.h5");
    const auto arrayOf = [&](const std::string& name) {
        return std::get<DataArray>(item(prefix + name).content);
    };
    const DataArray texels = arrayOf("texels");
    EXPECT_EQ(std::get<std::vector<std::int64_t>>(texels.values),
              std::vector<std::int64_t>(model.texels.texels.begin(), model.texels.texels.end()));
    const DataArray components = arrayOf("components");
    const auto used = static_cast<std::int64_t>(model.texels.texels.size());
    ASSERT_THAT(components.shape, ElementsAre(6, 3 * used));
    const Table<float>& eigenTextures = *std::get<SharedTable<float>>(components.values);
    ASSERT_THAT(arrayOf("warps").shape, ElementsAre(3, 2 * model.grid.nodes()));
    // A texture that is not warped is the mean and its components.
    const AppearanceCoefficients coefficients = coefficientsOf(model, 3);
    const std::vector<float> aligned = combined(model.textures, coefficients.textures);
    for (std::int64_t i = 0; i < 3 * used; i += 97) {
        double value =
            static_cast<double>(model.textures.meanStep) * model.textures.mean[static_cast<std::size_t>(i)];
        for (std::int64_t c = 0; c < 6; ++c)
            value += static_cast<double>(coefficients.textures[static_cast<std::size_t>(c)]) *
                     static_cast<double>(eigenTextures(c, i));
        EXPECT_NEAR(value, aligned[static_cast<std::size_t>(i)], 1e-3) << i;
    }
    const auto names = [&](const std::string& wanted) {
        std::vector<std::string> found;
        for (const DataItem& each : projectData(project, projectFile(), {}, wanted))
            found.push_back(each.name);
        return found;
    };
    EXPECT_THAT(names(prefix + "metrics"), ::testing::Not(Contains(prefix + "components")));
    EXPECT_THAT(names(prefix + "components"), Contains(prefix + "components"));
    look().components = 5;
    EXPECT_FALSE(item(prefix + "components").isFresh);
    folder.write(fs::relative(filesOfLook() / "model.h5", folder.path()).string(), "damaged");
    EXPECT_THROW(names(prefix + "components"), Error);
    EXPECT_THAT(names(prefix + "metrics"), Contains(prefix + "metrics"));
    fs::remove(filesOfLook() / "model.h5");
    EXPECT_THAT(names(prefix + "components"), ::testing::Not(Contains(prefix + "components")));
}

TEST_F(AppearanceSteps, ModelsThatCannotBeReadAreNotThereForClips)
{
    const auto known = [this] { return readAppearances(results(), folder.path(), look()); };
    EXPECT_FALSE(known());
    CompletionEntry completion;
    completion.frame = {"slow", FrameIndex(3)};
    completion.strokes = {{.points = {0.3, 0.5}, .radius = 0.1}};
    look().completions = {completion};
    run("appearance");
    ASSERT_TRUE(known());
    EXPECT_EQ(known()->completed.size(), 1U);
    fs::remove(filesOfLook() / "slow_3.png");
    EXPECT_TRUE(known()->completed.empty());
    folder.write(fs::relative(filesOfLook() / "model.h5", folder.path()).string(), "damaged");
    EXPECT_FALSE(known());
    fs::remove(filesOfLook() / "model.h5");
    EXPECT_FALSE(known());
    run("appearance");
    ASSERT_TRUE(known());
    EXPECT_EQ(known()->completed.size(), 1U);
    look().completions.clear();
    EXPECT_TRUE(known()->completed.empty());
}

TEST_F(AppearanceSteps, ComputeNothingTwice)
{
    run("appearance");
    age();
    EXPECT_THAT(computed(run("appearance")), ElementsAre());
    look().name = "other";
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/other/model"));
}

TEST_F(AppearanceSteps, ComputeNoFlowAgainForAnotherNumberOfComponents)
{
    run("appearance");
    ASSERT_FALSE(flows().empty());
    age();
    const std::vector<fs::path> before = flows();
    look().components = 4;
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model"));
    EXPECT_THAT(item("appearance/look/coefficients").shape(), ElementsAre(slowFrames + quickFrames, 3));
    EXPECT_EQ(flows(), before);
    EXPECT_THAT(writtenAgain(), ElementsAre());
}

TEST_F(AppearanceSteps, TakeTheFlowsOfTheirNameOfBefore)
{
    run("appearance");
    const fs::path first = flows().front();
    const fs::path second = flows().back();
    ASSERT_NE(textOf(first), textOf(second));
    folder.write(fs::relative(first, folder.path()).string(), textOf(second));
    look().name = "renamed";
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/renamed/model"));
    EXPECT_EQ(textOf(appearanceFolder(results(), "renamed") / "flows" / first.filename()), textOf(second))
        << "it was not computed again";
}

TEST_F(AppearanceSteps, TellFlowsOfLinearTexturesApart)
{
    const AppearanceWork work{std::make_shared<SequenceOpener>(project, folder.path(), results()), look(),
                              projectFile()};
    const std::vector<float> warp{1, 2};
    const FlowCache::Key key{.texture = 1, .reference = 0};
    const auto flowsOf = [&](const fs::path& file, ColourMarks marks) {
        AppearanceTraining training = appearanceTraining(*work.opener, look());
        training.textures = {training.textures.front(), {.file = file, .marks = marks}};
        return work.flows(training);
    };
    const auto plain = encodeImage(slowPattern(1), ".png");
    folder.write("plain.png", textOf(textureFile("slow", 1)));
    const auto marked = withPngGamma(plain, 100'000);
    folder.write("marked.png", std::string(reinterpret_cast<const char*>(marked.data()), marked.size()));
    for (const std::string name : {"plain.png", "marked.png"}) {
        flowsOf(folder / name, ColourMarks::Ignored).put(key, warp);
        EXPECT_EQ(flowsOf(folder / name, ColourMarks::Ignored).get(key), warp);
        EXPECT_EQ(flowsOf(folder / name, ColourMarks::Followed).get(key).has_value(), name == "plain.png");
    }
}

TEST_F(AppearanceSteps, ComputeADamagedFlowAgain)
{
    run("appearance");
    age();
    const fs::path damaged = flows().front();
    const std::string bytes = textOf(damaged);
    const std::string model = textOf(filesOfLook() / "model.h5");
    std::string flipped = bytes;
    flipped[bytes.size() / 2] ^= 0x41;
    for (const std::string& damage :
         {bytes.substr(0, bytes.size() / 2), bytes + "more", flipped, std::string("x")}) {
        folder.write(fs::relative(damaged, folder.path()).string(), damage);
        rebuild(project, projectFile(), {.targets = {"appearance"}, .force = true});
        EXPECT_EQ(textOf(damaged), bytes);
        EXPECT_EQ(textOf(filesOfLook() / "model.h5"), model);
        EXPECT_THAT(writtenAgain(), ElementsAre(damaged));
    }
}

TEST_F(AppearanceSteps, GoOnWhereTheyWereCancelled)
{
    CancelToken token;
    const Progress progress(token, [&](double fraction) {
        if (fraction > 0.6)
            token.cancel();
    });
    EXPECT_THROW(rebuild(project, projectFile(), {.targets = {"appearance"}, .jobs = 1}, progress), Error);
    EXPECT_FALSE(fs::exists(filesOfLook() / "model.h5"));
    const std::vector<fs::path> done = flows();
    ASSERT_FALSE(done.empty());
    age();
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model"));
    EXPECT_THAT(flows(), IsSupersetOf(done));
    for (const fs::path& file : done)
        EXPECT_THAT(writtenAgain(), ::testing::Not(Contains(file)));
    const std::string resumed = textOf(filesOfLook() / "model.h5");
    fs::remove_all(results());
    run("appearance");
    EXPECT_EQ(textOf(filesOfLook() / "model.h5"), resumed) << "as without a pause";
    EXPECT_EQ(std::distance(fs::directory_iterator(filesOfLook()), {}), 2) << "no scratch files are left";
}

TEST_F(AppearanceSteps, FillInAMaskedSquare)
{
    constexpr int frame = 6;
    completeSlow(frame);
    EXPECT_THAT(computed(run("appearance")),
                ElementsAre("appearance/look/model", "appearance/look/completions"));
    const auto rows = column<std::int64_t>("appearance/look/frames", "frame");
    EXPECT_EQ(rows.size(), slowFrames + quickFrames - 1U) << "it is not learned from";
    const Image completed = readImage(filesOfLook() / "slow_6.png");
    const Image& whole = slowPattern(frame);
    EXPECT_GE(similarityInSquare(whole, completed), 0.95);
    EXPECT_LT(similarityInSquare(whole, readImage(textureFile("slow", frame))), 0.5);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            ASSERT_TRUE(isInSquare(x, y) ||
                        std::equal(whole.pixel(x, y), whole.pixel(x, y) + 4, completed.pixel(x, y)))
                << "what is known stays: " << x << ", " << y;
        }
    }
}

TEST_F(AppearanceSteps, MakeNoModelAnewForAStroke)
{
    completeSlow(6);
    run("appearance");
    MaskStrokeEntry stroke;
    stroke.points = {0.3, 0.3, 0.4, 0.3};
    look().completions[0].strokes = {stroke};
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/completions"));
    writeImage(squareIn(Image(64, 64), 200), folder / "mask.png");
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/completions"));
    look().completions.push_back({.frame = {"quick", FrameIndex(2)}, .strokes = {stroke}});
    EXPECT_THAT(computed(run("appearance")),
                ElementsAre("appearance/look/model", "appearance/look/completions"));
    look().completions.clear();
    EXPECT_THAT(computed(run("appearance")), ElementsAre("appearance/look/model"));
}

TEST_F(AppearanceSteps, GiveSequencesWhatMakesTexturesBetweenTheirs)
{
    completeSlow(6);
    const auto before = opened("slow");
    const auto& sequence = before->sequence;
    ASSERT_TRUE(sequence.textures.blender());
    const auto between = [&](int first, int second, double weight) {
        return sequence.textures.blender()->between(capturedAt(sequence, first), capturedAt(sequence, second),
                                                    weight);
    };
    EXPECT_TRUE(between(2, 4, 0.5).isEmpty()) << "there is no model yet";
    run("appearance");
    EXPECT_EQ(*between(2, 4, 0).load(), slowPattern(2));
    EXPECT_NE(*between(2, 4, 0.5).load(), slowPattern(2));
    const Image completed = readImage(filesOfLook() / "slow_6.png");
    EXPECT_EQ(*sequence.textures.blender()->inPlaceOf(capturedAt(sequence, 6)).load(), completed);
    EXPECT_EQ(*between(6, 7, 0).load(), completed);
    project.appearances.clear();
    EXPECT_FALSE(opened("slow")->sequence.textures.blender());
}

TEST_F(AppearanceSteps, GiveOpenersOneModelUntilItIsMadeAnew)
{
    const auto sources = std::make_shared<SourceCache>();
    const auto blender = [&](const std::string& sequence = "slow") {
        return SequenceOpener(project, folder.path(), results(), sources)
            .open(sequence)
            ->sequence.textures.blender();
    };
    run("appearance");
    const auto first = blender();
    EXPECT_EQ(blender(), first);
    EXPECT_EQ(blender("quick"), first);
    EXPECT_NE(opened("slow")->sequence.textures.blender(), first) << "sources of its own";
    look().varied = VariedTextures::Nearest;
    EXPECT_NE(blender(), first);
    look().varied = VariedTextures::Learned;
    EXPECT_EQ(blender(), first);
    look().components = 4;
    run("appearance");
    const auto second = blender();
    EXPECT_NE(second, first) << "another model";
    completeSlow(6);
    run("appearance/look/completions");
    EXPECT_NE(blender(), second) << "another texture is completed";
}

TEST_F(AppearanceSteps, AreTheSameForAnyNumberOfThreads)
{
    completeSlow(6);
    rebuild(project, projectFile(), {.targets = {"appearance"}, .jobs = 1});
    const std::string model = textOf(filesOfLook() / "model.h5");
    const std::string completed = textOf(filesOfLook() / "slow_6.png");
    fs::remove_all(results());
    rebuild(project, projectFile(), {.targets = {"appearance"}, .jobs = 2});
    EXPECT_EQ(textOf(filesOfLook() / "model.h5"), model);
    EXPECT_EQ(textOf(filesOfLook() / "slow_6.png"), completed);
}
