// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/render/clipcamera.h"
#include "model/render/renderframe.h"
#include "model/sequence/io/clipexport.h"
#include "model/sequence/io/registry.h"
#include "scenes.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>
#include <set>
#include <tbb/global_control.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;

namespace {

class ClipExport : public ::testing::Test
{
protected:
    void SetUp() override
    {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        m_folder = fs::temp_directory_path() / (std::string("quadrille-") + test->name());
        fs::remove_all(m_folder);
    }
    void TearDown() override { fs::remove_all(m_folder); }

    fs::path m_folder;
};

ExportOptions small()
{
    ExportOptions options;
    options.render.look.width = 96;
    options.render.look.height = 64;
    return options;
}

std::string bytesOf(const fs::path& path)
{
    return std::string(readFile(path).text());
}

/// All frames of a video, each as its pixels; size and rate by reference.
std::vector<cv::Mat> decode(const fs::path& path, cv::Size& size, double& fps)
{
    cv::VideoCapture video(path.string());
    fps = video.get(cv::CAP_PROP_FPS);
    std::vector<cv::Mat> frames;
    cv::Mat frame;
    while (video.read(frame)) {
        size = frame.size();
        frames.push_back(frame.clone());
    }
    return frames;
}

} // namespace

TEST_F(ClipExport, WritesNumberedPicturesThatReadBackAsDrawn)
{
    const auto sequence = ball(16, 3);
    const auto options = small();
    const auto result = makePngExporter()->write(sequence, m_folder / "deep/ball.png", options, {});
    ASSERT_EQ(result.files.size(), 3U);
    EXPECT_EQ(result.files[2], m_folder / "deep/ball_0002.png");
    const auto cameras = clipCameras(sequence, options.render);
    const FrameRenderer renderer(sequence, options.render.look);
    for (std::size_t f = 0; f < 3; ++f)
        EXPECT_EQ(readImage(result.files[f]), renderer.render(FrameIndex(f), cameras[f]));
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder / "deep"), {}), 3);
}

TEST_F(ClipExport, WritesTheSamePicturesWithAnyNumberOfThreads)
{
    const auto sequence = ball(16, 6);
    const auto writeWith = [&](std::size_t threads, const char* name) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        std::string all;
        for (const auto& file : makePngExporter()->write(sequence, m_folder / name, small(), {}).files)
            all += bytesOf(file);
        return all;
    };
    EXPECT_EQ(writeWith(1, "one.png"), writeWith(4, "four.png"));
}

TEST_F(ClipExport, LeavesNothingBehindWhenCancelled)
{
    const auto sequence = ball(16, 40);
    for (const char* name : {"sub/ball.png", "sub/ball.mp4"}) {
        CancelToken token;
        const Progress progress(token, [&](double fraction) {
            if (fraction > 0.3)
                token.cancel();
        });
        const auto exporter = fs::path(name).extension() == ".png" ? makePngExporter() : makeVideoExporter();
        try {
            exporter->write(sequence, m_folder / name, small(), progress);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::Cancelled);
        }
        EXPECT_TRUE(!fs::exists(m_folder / "sub") || fs::is_empty(m_folder / "sub")) << name;
    }
}

TEST_F(ClipExport, KeepsOtherFilesOfTheFolderWhenCancelled)
{
    fs::create_directories(m_folder);
    std::ofstream(m_folder / "ball_0000.png") << "mine";
    const CancelToken token;
    const Progress progress(token);
    CancelToken(token).cancel();
    EXPECT_THROW(makePngExporter()->write(ball(8, 4), m_folder / "ball.png", small(), progress), Error);
    EXPECT_EQ(bytesOf(m_folder / "ball_0000.png"), "mine");
    EXPECT_EQ(std::distance(fs::directory_iterator(m_folder), {}), 1);
}

TEST_F(ClipExport, WritesVideosThatReadBack)
{
    auto sequence = ball(16, 12);
    sequence.fps = 30;
    for (const char* name : {"ball.mp4", "ball.avi"}) {
        makeVideoExporter()->write(sequence, m_folder / name, small(), {});
        cv::Size size;
        double fps = 0;
        const auto frames = decode(m_folder / name, size, fps);
        EXPECT_EQ(frames.size(), 12U) << name;
        EXPECT_EQ(size, cv::Size(96, 64));
        EXPECT_NEAR(fps, 30, 1e-3);
        const auto cameras = clipCameras(sequence, small().render);
        const auto drawn = renderFrame(sequence, FrameIndex(7), cameras[7], small().render.look);
        double difference = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 96; ++x)
                difference += std::abs(frames[7].at<cv::Vec3b>(y, x)[1] - drawn.pixel(x, y)[1]);
        }
        EXPECT_LT(difference / (96 * 64), 6) << name; // levels, lost by compression
    }
}

TEST_F(ClipExport, WritesTheSameFilmsWithAnyNumberOfThreads)
{
    const auto sequence = ball(16, 40);
    for (const std::string ending : {".mp4", ".avi"}) {
        const auto bytesWith = [&](std::size_t threads) {
            const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
            makeVideoExporter()->write(sequence, m_folder / ("film" + ending), small(), {});
            return bytesOf(m_folder / ("film" + ending));
        };
        EXPECT_EQ(bytesWith(1), bytesWith(4)) << ending;
    }
}

TEST_F(ClipExport, DrawsARowAndAColumnMoreWhereAFilmTakesEvenSizesOnly)
{
    auto options = small();
    options.render.look.width = 95;
    options.render.look.height = 63;
    cv::Size size;
    double fps = 0;
    const auto even = makeVideoExporter()->write(ball(8, 2), m_folder / "ball.mp4", options, {});
    EXPECT_EQ(decode(m_folder / "ball.mp4", size, fps).size(), 2U);
    EXPECT_EQ(size, cv::Size(96, 64));
    ASSERT_EQ(even.issues.size(), 1U);
    EXPECT_NE(even.issues.front().toString().find("96 × 64"), std::string::npos);
    const auto odd = makeVideoExporter()->write(ball(8, 2), m_folder / "ball.avi", options, {});
    EXPECT_EQ(decode(m_folder / "ball.avi", size, fps).size(), 2U);
    EXPECT_EQ(size, cv::Size(95, 63));
    EXPECT_TRUE(odd.issues.empty());
}

TEST_F(ClipExport, RefusesTransparencyAndTooSmallPicturesInVideos)
{
    auto options = small();
    options.render.look.width = 8;
    try {
        makeVideoExporter()->write(ball(8, 2), m_folder / "ball.mp4", options, {});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        EXPECT_EQ(error.context().file, m_folder / "ball.mp4");
    }
    options = small();
    options.render.look.background = RenderOptions::Background::Transparent;
    try {
        makeVideoExporter()->write(ball(8, 2), m_folder / "ball.mp4", options, {});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::FormatCannotStore);
    }
    EXPECT_FALSE(fs::exists(m_folder / "ball.mp4"));
}

TEST(ClipExporters, AreRegistered)
{
    std::set<std::string> ids;
    for (const auto& exporter : exporters())
        ids.insert(exporter->format().id);
    EXPECT_TRUE(ids.contains("png") && ids.contains("mp4"));
}

TEST(ClipCamera, FollowsTheFigureSmoothly)
{
    const auto sequence = ball(8, 40); // travels 0.1 m a frame along x
    const auto path = followPath(sequence, UpAxis::Y);
    for (std::size_t f = 1; f < path.size(); ++f) {
        EXPECT_NEAR(path[f].x() - path[f - 1].x(), 0.1, 1e-4);
        EXPECT_NEAR(path[f].y(), path[0].y(), 1e-12);
    }
    RenderSettings settings;
    settings.camera = CameraMode::Follow;
    const auto cameras = clipCameras(sequence, settings);
    EXPECT_TRUE((cameras[30].eye - cameras[0].eye).isApprox(path[30] - path[0], 1e-12));
}

TEST(ClipCamera, TurntableComesRoundOnceAndFixedStands)
{
    const auto sequence = ball(8, 40);
    RenderSettings settings;
    const auto turning = clipCameras(sequence, settings);
    const auto path = followPath(sequence, UpAxis::Y);
    const Vec3d opposite = turning[20].eye - turning[20].target;
    const Vec3d first = turning[0].eye - turning[0].target;
    EXPECT_NEAR(opposite.x(), -first.x(), 1e-9);
    EXPECT_NEAR(opposite.y(), first.y(), 1e-9);
    EXPECT_NEAR(opposite.z(), -first.z(), 1e-9);
    settings.camera = CameraMode::Fixed;
    const auto fixed = clipCameras(sequence, settings);
    EXPECT_EQ(fixed.front(), fixed.back());
    settings.view = unitCamera(9);
    EXPECT_EQ(clipCameras(sequence, settings)[5], unitCamera(9));
}
