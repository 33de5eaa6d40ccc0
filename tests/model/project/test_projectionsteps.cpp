// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/madeclips.h"
#include "model/project/store/resultplaces.h"
#include "tests/model/project/stripproject.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

/// A sheet of 2 × 2 that is wider in each frame, 4 before a camera whose pictures are brighter in each frame.
class ProjectionSteps : public StripProject
{
protected:
    ProjectionSteps()
    {
        for (int f = 0; f < frameCount; ++f) {
            folder.write("sheet/f_" + std::to_string(f) + ".obj", sheet(1 + 0.1 * f));
            picture(f, greyOf(f));
        }
        folder.write("cameras.json", tableOf(64));
        project.characters = {characterOf("strip", ""), characterOf("sheet", "")};
        for (SequenceEntry& sequence : project.sequences)
            sequence.character = "strip";
        project.sequences.push_back(sequenceOf("sheet", "sheet"));
        project.sequences.back().character = "sheet";
        ProjectionEntry entry;
        entry.name = "filmed";
        entry.clip = "sequences/sheet";
        entry.cameras = "cameras.json";
        entry.size = 16;
        project.projections = {entry};
    }

    static std::string sheet(double half)
    {
        const std::string x = std::to_string(half);
        return "v -" + x + " -1 0\nv " + x + " -1 0\nv " + x + " 1 0\nv -" + x +
               " 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    }
    /// It looks along −z from (0, 0, 4).
    static std::string tableOf(int side, const std::string& more = "")
    {
        const std::string middle = std::to_string(side / 2.0 - 0.5);
        return R"({"cameras": [{"name": "front", "size": [)" + std::to_string(side) + ", " +
               std::to_string(side) + R"(], "matrix": [[80, 0, )" + middle + "], [0, 80, " + middle +
               R"(], [0, 0, 1]], "rotation": [[1, 0, 0], [0, -1, 0], [0, 0, -1]], "translation": [0, 0, 4],
               "images": "front/p_####.png")" +
               more + "}]}";
    }
    static int greyOf(int frame) { return 100 + 50 * frame; }
    void picture(int frame, int grey) const
    {
        Image image(64, 64);
        std::ranges::fill(image.pixels, static_cast<std::uint8_t>(grey));
        std::filesystem::create_directories(folder / "front");
        writeImage(image, folder / ("front/p_000" + std::to_string(frame) + ".png"));
    }

    ProjectionEntry& projection() { return project.projections.front(); }
    std::shared_ptr<const OpenedSequence> opened(const std::string& clip = "projections/filmed")
    {
        return SequenceOpener(project, folder.path(), cacheFolder(folder / "p.quadrille")).openClip(clip);
    }
    /// The grey in the middle of the texture of each frame.
    std::vector<int> greys(const std::string& clip = "projections/filmed")
    {
        const auto made = opened(clip);
        std::vector<int> values;
        for (FrameIndex f(0); f.value < made->sequence.frameCount(); ++f)
            values.push_back(made->sequence.texture(f)->pixel(8, 8)[0]);
        return values;
    }
    std::string failure()
    {
        for (const StepReport& step : run("projections").steps) {
            if (step.error)
                return step.error->what();
        }
        return "";
    }

    static constexpr int frameCount = 3;
};

} // namespace

TEST_F(ProjectionSteps, MakeATextureForEachFrameOfAClip)
{
    EXPECT_THAT(computed(run("projections")), ElementsAre("projections/filmed/textures"));
    EXPECT_THAT(greys(), ElementsAre(100, 150, 200));
    const auto made = opened();
    const auto sheet = opened("sequences/sheet");
    EXPECT_EQ(made->sequence.name, "filmed");
    EXPECT_EQ(made->sequence.topology->data(), sheet->sequence.topology->data());
    EXPECT_EQ(made->sequence.texture(FrameIndex(1))->width, 16);
    for (FrameIndex f(0); f.value < frameCount; ++f)
        EXPECT_EQ(made->sequence.frame(f).positions()[1], sheet->sequence.frame(f).positions()[1]);
    EXPECT_THAT(column<double>("projections/filmed/coverage", "seen"), Each(::testing::Gt(0.7)));
    EXPECT_THAT(column<double>("projections/filmed/coverage", "cameras"), Each(1));
    EXPECT_THAT(column<std::string>("projections/filmed/cameras", "camera"), ElementsAre("front"));
    EXPECT_THAT(column<std::int64_t>("projections/filmed/cameras", "pictures"), ElementsAre(3));
    EXPECT_NEAR(column<double>("projections/filmed/cameras", "share")[0], 1, 1e-6);
    const auto times = std::get<DataArray>(item("projections/filmed/times-seen").content);
    EXPECT_EQ(times.shape, (std::vector<std::int64_t>{16, 16}));
    EXPECT_EQ(std::get<std::vector<std::int64_t>>(times.values)[8 * 16 + 8], 3);
}

TEST_F(ProjectionSteps, AreFreshUntilSomethingTheyNeedChanges)
{
    const auto textures = ElementsAre("projections/filmed/textures");
    run("projections");
    EXPECT_THAT(computed(run("projections")), IsEmpty());
    projection().sharpness = 5;
    EXPECT_THAT(computed(run("projections")), textures);
    picture(1, 90);
    EXPECT_THAT(computed(run("projections")), textures);
    EXPECT_THAT(greys(), ElementsAre(100, 90, 200));
    folder.write("cameras.json", tableOf(64, R"(, "first_frame": 1)"));
    EXPECT_THAT(computed(run("projections")), textures);
    EXPECT_THAT(greys(), ElementsAre(90, 200, 90)); // nobody sees the last one
    folder.write("sheet/f_1.obj", sheet(0.9));
    EXPECT_THAT(computed(run("projections")), textures);
    // The same pictures, of which one shows another frame.
    std::filesystem::rename(folder / "front/p_0002.png", folder / "front/p_0003.png");
    EXPECT_THAT(computed(run("projections")), textures);
    EXPECT_THAT(greys(), ElementsAre(90, 90, 200));
    std::filesystem::remove(cacheFolder(folder / "p.quadrille") / "projections/filmed/files/0001.png");
    EXPECT_THAT(computed(run("projections")), textures);
}

TEST_F(ProjectionSteps, GoWithTheFramesOfWhatIsCut)
{
    SequenceEntry& sheet = project.sequences.back();
    sheet.range = FrameRange{FrameIndex(1), FrameIndex(2)};
    SequenceEntry shown = sequenceOf("shown", "clip:projections/filmed");
    shown.character = "sheet";
    shown.range = FrameRange{FrameIndex(1), FrameIndex(1)};
    project.sequences.push_back(shown);
    run("projections");
    // The first frame that is left is the first of the clip, and has the first picture.
    EXPECT_THAT(greys(), ElementsAre(100, 150));
    EXPECT_THAT(greys("sequences/shown"), ElementsAre(150));
    EXPECT_EQ(characterOfClip(project, "projections/filmed"), "sheet");
    EXPECT_EQ(sequencesOfClip(project, "projections/filmed"), std::vector<std::string>{"sheet"});
    EXPECT_EQ(shownClip(project, project.sequences.back()), "projections/filmed");
}

TEST_F(ProjectionSteps, MayShowOneAnother)
{
    ProjectionEntry again = projection();
    again.name = "again";
    again.clip = "projections/filmed";
    project.projections.insert(project.projections.begin(), again);
    EXPECT_THAT(computed(run("projections")),
                ElementsAre("projections/filmed/textures", "projections/again/textures"));
    EXPECT_THAT(greys("projections/again"), ElementsAre(100, 150, 200));
    EXPECT_EQ(characterOfClip(project, "projections/again"), "sheet");
    project.projections[1].clip = "projections/again";
    EXPECT_EQ(characterOfClip(project, "projections/again"), "");
    EXPECT_THAT(sequencesOfClip(project, "projections/again"), IsEmpty());
    EXPECT_THROW(opened(), Error);
}

TEST_F(ProjectionSteps, LeaveNoTexturesOfFramesThatAreGone)
{
    run("projections");
    project.sequences.back().range = FrameRange{FrameIndex(0), FrameIndex(1)};
    EXPECT_THROW(opened(), Error); // there is one too many
    run("projections");
    EXPECT_THAT(greys(), ElementsAre(100, 150));
    int files = 0;
    for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(
             cacheFolder(folder / "p.quadrille") / "projections/filmed/files"))
        ++files;
    EXPECT_EQ(files, 2);
}

TEST_F(ProjectionSteps, AreExportedWithTheirTextures)
{
    ExportEntry entry;
    entry.name = "film";
    entry.what = "projections/filmed";
    entry.path = "out/film.obj";
    project.exports = {entry};
    EXPECT_THAT(computed(run("exports")), ElementsAre("projections/filmed/textures", "exports/film"));
    int pictures = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder / "out"))
        pictures += file.path().extension() == ".png" ? 1 : 0;
    EXPECT_EQ(pictures, 3);
    picture(0, 30);
    EXPECT_THAT(computed(run("exports")), ElementsAre("projections/filmed/textures", "exports/film"));
}

TEST_F(ProjectionSteps, ProtectTheirPictures)
{
    ExportEntry entry;
    entry.name = "frames";
    entry.what = "sequences/sheet";
    entry.path = "front/p_####.png";
    project.exports = {entry};
    const RebuildReport report = run("exports");
    ASSERT_FALSE(report.steps.empty());
    ASSERT_TRUE(report.steps.back().error);
    EXPECT_THAT(report.steps.back().error->what(), HasSubstr("projections/filmed"));
    EXPECT_EQ(readImage(folder / "front/p_0000.png").width, 64);
}

TEST_F(ProjectionSteps, SayWhatIsWrong)
{
    folder.write("cameras.json", tableOf(32));
    EXPECT_THAT(failure(), HasSubstr("This picture has 64 × 64 pixels, and the camera “front” 32 × 32"));
    folder.write("cameras.json", "{");
    EXPECT_THAT(failure(), HasSubstr("cameras.json"));
    projection().cameras = "none.json";
    EXPECT_THAT(failure(), HasSubstr("none.json"));
    folder.write("cameras.json", tableOf(64));
    projection().cameras = "cameras.json";
    projection().clip = "sequences/slow"; // strips have no UVs
    EXPECT_THAT(failure(), HasSubstr("texture coordinates"));
    projection().clip = "sequences/sheet";
    std::filesystem::remove(folder / "front/p_0001.png");
    const RebuildReport report = run("projections");
    ASSERT_EQ(report.steps.size(), 1U);
    ASSERT_EQ(report.steps[0].issues.size(), 1U);
    EXPECT_THAT(report.steps[0].issues[0].toString(), HasSubstr("1 of its 3 frames"));
}
