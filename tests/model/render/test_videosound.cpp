// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/render/clipcamera.h"
#include "model/sequence/io/clipexport.h"
#include "scenes.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"
#include "tests/model/film/boxreader.h"
#include "tests/model/project/testproject.h"

#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;

namespace {

/// Half a second of a bending figure, with a tone of 0.2 s.
class VideoSound : public ::testing::Test
{
protected:
    VideoSound()
    {
        sequence.fps = 24;
        options.render.look.width = 96;
        options.render.look.height = 64;
        options.sound = SoundTrack{folder.write("a.wav", wavOf(tone(0.2))), 0.1, 0};
    }
    ExportResult write(const std::string& name)
    {
        return makeVideoExporter()->write(sequence, folder / name, options, {});
    }
    /// The sound's track of the written file.
    std::string_view track(const std::string& name)
    {
        content = readFile(folder / name);
        const auto tracks = boxesOf(boxOf(content.text(), "moov"), "trak");
        EXPECT_EQ(tracks.size(), 2U);
        EXPECT_EQ(boxOf(tracks.back(), "mdia/hdlr").substr(8, 4), "soun");
        return tracks.back();
    }
    /// The sound that a decoder finds.
    Sound decoded(std::string_view track)
    {
        std::string bytes;
        for (const std::string_view frame : samplesOf(content.text(), track))
            bytes += frame;
        return readSound(folder.write("back.mp3", bytes));
    }

    TemporaryFolder folder;
    MeshSequence sequence = quadrille::test::ball(6, 12);
    ExportOptions options;
    FileContent content;
};

} // namespace

TEST_F(VideoSound, IsATrackBesideThePicture)
{
    options.sound.reset();
    write("mute.mp4");
    options.sound = SoundTrack{folder / "a.wav", 0.1, 0};
    write("loud.mp4");
    const auto frames = [&](const std::string& name) {
        cv::VideoCapture video((folder / name).string());
        std::vector<cv::Mat> all;
        for (cv::Mat frame; video.read(frame);)
            all.push_back(frame.clone());
        return all;
    };
    const auto mute = frames("mute.mp4");
    const auto loud = frames("loud.mp4");
    ASSERT_EQ(loud.size(), 12U);
    ASSERT_EQ(mute.size(), 12U);
    for (std::size_t i = 0; i < loud.size(); ++i)
        EXPECT_EQ(cv::norm(mute[i], loud[i], cv::NORM_INF), 0) << i;
    EXPECT_EQ(boxesOf(boxOf(readFile(folder / "mute.mp4").text(), "moov"), "trak").size(), 1U);
}

TEST_F(VideoSound, BeginsAndEndsInTime)
{
    write("a.mp4");
    const auto sound = track("a.mp4");
    // The track shows as long as the movie, from its first sample.
    const auto header = boxOf(content.text(), "moov/mvhd");
    const auto edit = boxOf(sound, "edts/elst");
    EXPECT_EQ(numberAt(edit, 8, 8), numberAt(header, 24, 8));
    EXPECT_EQ(numberAt(edit, 16, 8), 0U);
    EXPECT_EQ(numberAt(boxOf(sound, "mdia/mdhd"), 20, 4), 48000U);
    const Sound back = decoded(sound);
    const auto loudest = [&](double from, double to) {
        float peak = 0;
        for (auto f = static_cast<std::int64_t>(from * 48000); f < static_cast<std::int64_t>(to * 48000); ++f)
            peak = std::max(peak, std::abs(back.samples.at(static_cast<std::size_t>(f))));
        return peak;
    };
    EXPECT_LT(loudest(0.03, 0.095), 0.01);
    EXPECT_NEAR(loudest(0.105, 0.295), 0.5, 0.05);
    EXPECT_LT(loudest(0.305, 0.48), 0.01);
}

TEST_F(VideoSound, LongerThanTheVideoIsTrimmed)
{
    options.sound = SoundTrack{folder.write("long.wav", wavOf(tone(3, 44100, 2))), -1, 0};
    write("a.mp4");
    const auto sound = track("a.mp4");
    EXPECT_EQ(samplesOf(content.text(), sound).size(),
              (22050U + 1151) / 1152); // half a second, in whole frames
    EXPECT_EQ(decoded(sound).channels, 2);
}

TEST_F(VideoSound, IsLeftOutWhereTheFormatHoldsNone)
{
    const auto result = write("a.avi");
    ASSERT_EQ(result.issues.size(), 1U);
    EXPECT_NE(result.issues.front().toString().find("sound was left out"), std::string::npos);
}

TEST_F(VideoSound, ThatIsMissingStopsTheExport)
{
    options.sound->file = folder / "none.wav";
    EXPECT_EQ(codeOf([&] { write("a.mp4"); }), ErrorCode::FileNotFound);
    EXPECT_FALSE(fs::exists(folder / "a.mp4"));
}

TEST_F(VideoSound, ShowsWhatTheCameraKeysSay)
{
    options.render.keys = {{.time = 0, .distance = 3}, {.time = 0.25, .distance = 6, .azimuth = 90}};
    options.render.look.axes.up = UpAxis::Y;
    const auto cameras = clipCameras(sequence, options.render);
    ASSERT_EQ(cameras.size(), 12U);
    EXPECT_LT((cameras.front().eye - Vec3d(0, 0, 3)).norm(), 1e-9);
    EXPECT_LT((cameras[6].eye - Vec3d(6, 0, 0)).norm(), 1e-9);
    EXPECT_EQ(cameras.back(), cameras[6]);
}
