// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/project/media/cameratable.h"
#include "tests/model/core/temporaryfolder.h"

#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

const std::string matrixText = R"("matrix": [[900, 0, 639.5], [0, 910, 479.5], [0, 0, 1]])";
const std::string poseText = R"("rotation": [[0, -1, 0], [0, 0, -1], [1, 0, 0]], "translation": [1, 2, 3])";

class CameraTable : public ::testing::Test
{
protected:
    CameraTable()
    {
        for (const int number : {7, 8, 10})
            folder.write("left/img_" + std::to_string(number) + ".png", "");
        folder.write("one.png", "");
    }

    static std::string camera(const std::string& members) { return "{\"cameras\": [\n{" + members + "}]}"; }
    std::string whole(const std::string& images) const
    {
        return camera(R"("name": "left", "size": [1280, 960], )" + matrixText + ", " + poseText +
                      R"(, "images": ")" + images + "\"");
    }
    std::vector<CameraSeries> read(const std::string& text, std::optional<CoordinateSystem> from = {}) const
    {
        folder.write("cameras.json", text);
        return readCameraTable(folder / "cameras.json", from, {UpAxis::Y, 1});
    }
    std::string failure(const std::string& text) const
    {
        try {
            read(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    std::string without(const std::string& part, const std::string& instead = "") const
    {
        std::string text = whole("one.png");
        return text.replace(text.find(part), part.size(), instead);
    }

    TemporaryFolder folder;
};

} // namespace

TEST_F(CameraTable, IsReadWithItsPictures)
{
    const auto all = read(whole("left/img_#.png"));
    ASSERT_EQ(all.size(), 1U);
    const PinholeCamera& camera = all.front().camera;
    EXPECT_EQ(camera.name, "left");
    EXPECT_EQ(camera.width, 1280);
    EXPECT_EQ(camera.height, 960);
    EXPECT_EQ(Eigen::Vector4d(camera.fx, camera.fy, camera.cx, camera.cy),
              Eigen::Vector4d(900, 910, 639.5, 479.5));
    EXPECT_EQ(camera.rotation.row(0), Eigen::RowVector3d(0, -1, 0));
    EXPECT_EQ(camera.translation, Vec3d(1, 2, 3));
    EXPECT_EQ(all.front().pictureOf(FrameIndex(0)).filename(), "img_7.png");
    EXPECT_EQ(all.front().pictureOf(FrameIndex(1)).filename(), "img_8.png");
    EXPECT_TRUE(all.front().pictureOf(FrameIndex(2)).empty()); // img_9 is missing
    EXPECT_EQ(all.front().pictureOf(FrameIndex(3)).filename(), "img_10.png");
    EXPECT_EQ(read(whole("left")).front().pictures, all.front().pictures);
    EXPECT_EQ(read(whole("one.png")).front().pictureOf(FrameIndex(0)).filename(), "one.png");
}

TEST_F(CameraTable, MayBeginAtAnotherPictureAndDistort)
{
    const std::string members = R"("name": "left", "size": [1280, 960], )" + matrixText + ", " + poseText +
                                R"(, "images": "left/img_#.png", )";
    const auto all =
        read(camera(members + R"("first_frame": 8, "distortion": [[-0.1, 0.02, 0.001, 0.002]])"));
    EXPECT_EQ(all.front().pictureOf(FrameIndex(0)).filename(), "img_8.png");
    EXPECT_EQ(all.front().camera.distortion, (std::array{-0.1, 0.02, 0.001, 0.002, 0.0}));
    EXPECT_THAT(failure(camera(members + R"("distortion": [1, 2, 3, 4, 5, 6])")), HasSubstr("up to five"));
}

TEST_F(CameraTable, IsBroughtIntoTheAxesOfTheProject)
{
    // A point of a world in millimetres with z up, and the same in metres with y up.
    const CoordinateSystem millimetres{UpAxis::Z, 0.001};
    const PinholeCamera own = read(whole("one.png")).front().camera;
    const PinholeCamera camera = read(whole("one.png"), millimetres).front().camera;
    const Vec3d point(300, -20, 1700);
    const Vec3d inProject = conversionMatrix(millimetres, {UpAxis::Y, 1}).cast<double>() * point;
    EXPECT_FALSE(faultOf(camera));
    EXPECT_TRUE((1000 * camera.inCamera(inProject)).isApprox(own.inCamera(point), 1e-6));
}

TEST_F(CameraTable, SaysWhatIsWrongAndWhere)
{
    EXPECT_EQ(failure(whole("one.png")), "");
    EXPECT_THAT(failure("{\"cameras\": [\n{"), HasSubstr("cameras.json"));
    EXPECT_THAT(failure("{}"), HasSubstr("There are no cameras here"));
    EXPECT_THAT(failure("[]"), HasSubstr("An object in braces"));
    EXPECT_THAT(failure(R"({"cameras": [3]})"),
                HasSubstr("An object in braces is expected here. (line 1, column 14)"));
    EXPECT_THAT(failure(without(R"("name": "left",)")),
                AllOf(HasSubstr("“name” is missing"), HasSubstr("line 2")));
    EXPECT_THAT(failure(without("[1280, 960]", "1280")), HasSubstr("“size” must be [width, height]"));
    EXPECT_THAT(failure(without("1280", "1e12")), HasSubstr("1000000 × 960 pixels"));
    EXPECT_THAT(failure(without("[0, 0, 1]", "[0, 0, 2]")), HasSubstr("shears"));
    EXPECT_THAT(failure(without("[0, 0, 1]", "[0, 0]")), HasSubstr("“matrix” must be [[fx, 0, cx]"));
    EXPECT_THAT(failure(without("900", "-900")), HasSubstr("focal lengths"));
    EXPECT_THAT(failure(without("900", "\"long\"")), HasSubstr("“matrix” must be"));
    EXPECT_THAT(failure(without("[1, 0, 0]", "[-1, 0, 0]")), HasSubstr("mirrors"));
    EXPECT_THAT(failure(without("[1, 2, 3]", "[1, 2]")), HasSubstr("“translation” must be three numbers"));
    EXPECT_THAT(failure(whole("none.png")), HasSubstr("none.png"));
    EXPECT_THAT(failure(whole("left/x_#.png")), HasSubstr("x_#.png"));
    const std::string one = whole("one.png").substr(13, whole("one.png").size() - 15);
    EXPECT_THAT(failure("{\"cameras\": [" + one + ", " + one + "]}"), HasSubstr("two cameras “left”"));
}
