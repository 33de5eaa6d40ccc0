// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/film/avifilm.h"
#include "model/film/mp4film.h"
#include "tests/model/audio/tone.h"
#include "tests/model/codeof.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/film/boxreader.h"
#include "tests/model/film/pictures.h"

#include <bitset>
#include <opencv2/videoio.hpp>
#include <wels/codec_api.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;

namespace {

/// Grey levels that tell frames from another.
std::uint8_t levelOf(std::int64_t frame)
{
    return static_cast<std::uint8_t>(20 + 13 * (frame % 17));
}

std::unique_ptr<FilmWriter> writerOf(const fs::path& file, const FilmFormat& format,
                                     std::optional<Mp3Stream> sound = {})
{
    if (file.extension() == ".avi")
        return std::make_unique<AviFilm>(file, file, format);
    return std::make_unique<Mp4Film>(file, file, format, std::move(sound));
}

/// A film of plain pictures.
void writeLevels(const fs::path& file, const FilmFormat& format, std::optional<Mp3Stream> sound = {})
{
    const auto writer = writerOf(file, format, std::move(sound));
    for (std::int64_t frame = 0; frame < format.frames; ++frame) {
        const std::uint8_t level = levelOf(frame);
        writer->add(plain(format.width, format.height, {level, level, level}));
    }
    writer->finish();
}

/// The first picture of an MP4 film as a decoder gives it, in planes.
class Decoded
{
public:
    explicit Decoded(std::string_view file)
    {
        const auto track = boxesOf(boxOf(file, "moov"), "trak").front();
        const auto entry = boxOf(boxOf(track, "mdia/minf/stbl/stsd").substr(8), "avc1");
        const auto decoder = boxOf(entry.substr(78), "avcC");
        const std::size_t sequenceBytes = numberAt(decoder, 6, 2);
        sequenceSet = decoder.substr(8, sequenceBytes);
        colors = boxOf(entry.substr(78), "colr");
        const auto pictureSet = decoder.substr(8 + sequenceBytes + 3);
        const auto sample = samplesOf(file, track).front();
        EXPECT_EQ(numberAt(sample, 0, 4), sample.size() - 4);
        std::string stream;
        for (const auto unit : {sequenceSet, pictureSet, sample.substr(4)})
            stream.append("\0\0\0\1", 4).append(unit);
        ISVCDecoder* made = nullptr;
        EXPECT_EQ(WelsCreateDecoder(&made), 0);
        m_decoder.reset(made);
        const SDecodingParam parameters{};
        EXPECT_EQ(made->Initialize(&parameters), 0);
        const auto* bytes = reinterpret_cast<const unsigned char*>(stream.data());
        made->DecodeFrameNoDelay(bytes, static_cast<int>(stream.size()), m_planes.data(), &m_info);
        if (m_info.iBufferStatus != 1)
            made->FlushFrame(m_planes.data(), &m_info);
        EXPECT_EQ(m_info.iBufferStatus, 1);
    }
    int width() const { return m_info.UsrData.sSystemBuffer.iWidth; }
    int height() const { return m_info.UsrData.sSystemBuffer.iHeight; }
    /// The value of a plane at a place of the whole picture.
    int at(std::size_t plane, int x, int y) const
    {
        const int scale = plane == 0 ? 1 : 2;
        const int stride = m_info.UsrData.sSystemBuffer.iStride[plane == 0 ? 0 : 1];
        return m_planes.at(plane)[y / scale * stride + x / scale];
    }

    std::string_view sequenceSet;
    std::string_view colors;

private:
    struct Destroy
    {
        void operator()(ISVCDecoder* decoder) const
        {
            decoder->Uninitialize();
            WelsDestroyDecoder(decoder);
        }
    };
    std::unique_ptr<ISVCDecoder, Destroy> m_decoder;
    std::array<unsigned char*, 3> m_planes{};
    SBufferInfo m_info{};
};

} // namespace

TEST(FrameRate, IsTheFractionThatFilmsHave)
{
    EXPECT_EQ(frameRateOf(25), (FrameRate{25, 1}));
    EXPECT_EQ(frameRateOf(12.5), (FrameRate{25, 2}));
    EXPECT_EQ(frameRateOf(29.97), (FrameRate{2997, 100}));
    EXPECT_EQ(frameRateOf(30000.0 / 1001), (FrameRate{30000, 1001}));
    EXPECT_EQ(frameRateOf(24000.0 / 1001), (FrameRate{24000, 1001}));
    EXPECT_EQ(frameRateOf(0.04), (FrameRate{1, 25}));
    EXPECT_EQ(frameRateOf(1e9), (FrameRate{1000000, 1}));
    for (const double fps : {std::numbers::pi, 1e-6, 1e6, 1.0 / 1234.5, 47.95204}) {
        const FrameRate rate = frameRateOf(fps);
        EXPECT_NEAR(static_cast<double>(rate.units) / rate.unitsPerFrame / fps, 1, 1e-3) << fps;
    }
}

TEST(Films, HaveTheirPicturesInOrderAtTheirRate)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "a.avi"}) {
        for (const double fps : {25.0, 29.97, 12.5, 30000.0 / 1001, 1.0, 120.0}) {
            for (const std::int64_t frames : {1, 2, 37, 131}) {
                writeLevels(folder / name, {64, 48, fps, frames});
                cv::VideoCapture video((folder / name).string());
                EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), fps, 1e-6 * fps) << name;
                EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_COUNT), static_cast<double>(frames));
                std::int64_t count = 0;
                for (cv::Mat picture; video.read(picture); ++count) {
                    ASSERT_EQ(picture.size(), cv::Size(64, 48));
                    ASSERT_NEAR(picture.at<cv::Vec3b>(24, 32)[1], levelOf(count), 2) << name << ' ' << count;
                }
                EXPECT_EQ(count, frames) << name << ' ' << fps;
            }
        }
    }
}

TEST(Films, LastAsLongAsTheirPictures)
{
    const TemporaryFolder folder;
    for (const double fps : {25.0, 29.97, 12.5, 30000.0 / 1001, 0.01}) {
        writeLevels(folder / "a.mp4", {32, 32, fps, 37});
        const FileContent content = readFile(folder / "a.mp4");
        const auto movie = boxOf(content.text(), "moov");
        for (const auto header : {boxOf(movie, "mvhd"), boxOf(movie, "trak/mdia/mdhd")}) {
            const auto units = static_cast<double>(numberAt(header, 20, 4));
            EXPECT_NEAR(static_cast<double>(numberAt(header, 24, 8)) / units, 37 / fps, 1e-9 * 37 / fps);
        }
        // A key picture every two seconds.
        const auto keys = boxOf(movie, "trak/mdia/minf/stbl/stss");
        const auto apart = static_cast<std::uint64_t>(std::max(1L, std::lround(2 * fps)));
        EXPECT_EQ(numberAt(keys, 4, 4), (37 + apart - 1) / apart);
        EXPECT_EQ(numberAt(keys, 8, 4), 1U);
        if (apart < 37) {
            EXPECT_EQ(numberAt(keys, 12, 4), 1 + apart);
        }
    }
}

TEST(Films, HaveTheColorsThatTheySay)
{
    const TemporaryFolder folder;
    const auto writer = writerOf(folder / "a.mp4", {64, 64, 25, 1});
    writer->add(quarters(64, 64, {Color{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}}));
    writer->finish();
    const FileContent content = readFile(folder / "a.mp4");
    const Decoded decoded(content.text());
    ASSERT_EQ(decoded.width(), 64);
    ASSERT_EQ(decoded.height(), 64);
    constexpr std::array<std::array<int, 3>, 4> known{
        {{63, 102, 240}, {173, 42, 26}, {32, 240, 118}, {235, 128, 128}}}; // BT.709
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const int x = quarter % 2 == 0 ? 16 : 48;
        const int y = quarter < 2 ? 16 : 48;
        for (std::size_t plane = 0; plane < 3; ++plane)
            EXPECT_NEAR(decoded.at(plane, x, y), known.at(quarter).at(plane), 1) << quarter << ' ' << plane;
    }
    // The file: primaries, transfer and matrix 1, the range of films.
    EXPECT_EQ(decoded.colors, std::string_view("nclx\0\1\0\1\0\1\0", 11));
    // The stream: the same behind "signal type present, undefined format, no full range, colours present".
    std::string bits;
    for (const char byte : decoded.sequenceSet)
        bits += std::bitset<8>(static_cast<unsigned char>(byte)).to_string();
    EXPECT_NE(bits.find("110101000000010000000100000001"), std::string::npos) << bits;
}

TEST(Films, HaveTheirTablesFirstAndTheirSoundBesideThePictures)
{
    const TemporaryFolder folder;
    const Mp3Stream sound = encodeMp3(tone(3));
    writeLevels(folder / "a.mp4", {32, 32, 25, 75}, sound);
    const FileContent content = readFile(folder / "a.mp4");
    const std::string_view file = content.text();
    EXPECT_LT(file.find("moov"), file.find("mdat"));
    const auto tracks = boxesOf(boxOf(file, "moov"), "trak");
    ASSERT_EQ(tracks.size(), 2U);
    EXPECT_EQ(samplesOf(file, tracks[0]).size(), 75U);
    const auto frames = samplesOf(file, tracks[1]);
    ASSERT_EQ(frames.size(), sound.frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        EXPECT_EQ(frames[i], sound.frames[i]) << i;
    // What is heard at a second lies between what is seen half a second before and after.
    const auto placeOf = [&](std::string_view sample) { return sample.data() - file.data(); };
    for (const std::size_t second : {1U, 2U}) {
        const auto place = placeOf(frames.at(second * 48000 / 1152));
        EXPECT_GT(place, placeOf(samplesOf(file, tracks[0]).at(second * 25 - 13)));
        EXPECT_LT(place, placeOf(samplesOf(file, tracks[0]).at(second * 25 + 14)));
    }
    // All of the file is in boxes, and all pictures and sounds are in one of them.
    EXPECT_EQ(boxesOf(file, "ftyp").size(), 1U);
    std::size_t bytes = 0;
    for (const auto track : tracks) {
        for (const auto sample : samplesOf(file, track))
            bytes += sample.size();
    }
    EXPECT_EQ(boxOf(file, "mdat").size(), bytes);
}

TEST(Films, MayHaveSoundOfAnyLength)
{
    const TemporaryFolder folder;
    for (const double seconds : {0.001, 0.04, 5.0}) {
        for (const std::int64_t frames : {1, 11, 40}) {
            const Mp3Stream sound = encodeMp3(tone(seconds));
            writeLevels(folder / "a.mp4", {32, 32, 10, frames}, sound);
            const FileContent content = readFile(folder / "a.mp4");
            const auto tracks = boxesOf(boxOf(content.text(), "moov"), "trak");
            EXPECT_EQ(samplesOf(content.text(), tracks.front()).size(), static_cast<std::size_t>(frames));
            ASSERT_EQ(tracks.size(), 2U);
            EXPECT_EQ(samplesOf(content.text(), tracks.back()).size(), sound.frames.size());
        }
    }
    writeLevels(folder / "a.mp4", {32, 32, 10, 3}, encodeMp3(tone(0)));
    EXPECT_EQ(boxesOf(boxOf(readFile(folder / "a.mp4").text(), "moov"), "trak").size(), 1U);
}

TEST(Films, RefuseSizesThatTheyCannotHave)
{
    const TemporaryFolder folder;
    struct Refused
    {
        int width;
        int height;
        const char* remedy;
    };
    for (const Refused& refused :
         {Refused{95, 64, "Choose even numbers of pixels."},
          Refused{64, 33, "Choose even numbers of pixels."}, Refused{14, 64, "Choose a larger size."},
          Refused{4098, 2304, "Choose a smaller size, or write PNG pictures."}}) {
        try {
            writerOf(folder / "film.mp4", {refused.width, refused.height, 25, 1});
            ADD_FAILURE() << refused.width;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::BadArgument);
            EXPECT_EQ(error.context().file, folder / "film.mp4");
            EXPECT_NE(std::string_view(error.what()).find(refused.remedy), std::string_view::npos)
                << error.what();
        }
    }
    for (const auto& [width, height] : {std::pair{16, 16}, {4096, 2304}, {2304, 4096}, {18, 8192}})
        writeLevels(folder / "film.mp4", {width, height, 25, 1});
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 9}}) {
        writeLevels(folder / "film.avi", {width, height, 25, 3});
        cv::Mat picture;
        EXPECT_TRUE(cv::VideoCapture((folder / "film.avi").string()).read(picture));
        EXPECT_EQ(picture.size(), cv::Size(width, height));
    }
}

TEST(Films, NameThemselvesWhereTheyCannotBeWritten)
{
    for (const char* name : {"film.mp4", "film.avi"}) {
        for (const char* place : {"/dev/full", "/nowhere/film"}) {
            const FilmFormat format{256, 256, 25, 40};
            try {
                std::unique_ptr<FilmWriter> writer;
                if (fs::path(name).extension() == ".avi")
                    writer = std::make_unique<AviFilm>(place, name, format);
                else
                    writer = std::make_unique<Mp4Film>(place, name, format);
                for (std::int64_t frame = 0; frame < format.frames; ++frame)
                    writer->add(quarters(256, 256));
                writer->finish();
                ADD_FAILURE() << name << ' ' << place;
            } catch (const Error& error) {
                EXPECT_EQ(error.context().file, name);
                EXPECT_NE(error.code(), ErrorCode::Unexpected);
            }
        }
    }
}

TEST(Films, RefuseToBeLargerThanTheirFormat)
{
    const TemporaryFolder folder;
    const fs::path file = folder / "a.avi";
    AviFilm film(file, file, {64, 64, 25, 100}, 10000);
    const auto addAll = [&] {
        for (int frame = 0; frame < 100; ++frame)
            film.add(quarters(64, 64));
    };
    EXPECT_EQ(codeOf(addAll), ErrorCode::BadArgument);
    film.finish();
    EXPECT_LE(fs::file_size(file), 10000U);
    EXPECT_GE(fs::file_size(file), 8000U);
}
