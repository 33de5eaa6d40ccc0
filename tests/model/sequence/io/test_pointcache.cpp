// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "model/sequence/io/basemesh.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <sys/resource.h>

using namespace quadrille;
using ::testing::HasSubstr;

namespace {

constexpr std::string_view triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

template <typename T>
std::string bytes(T value)
{
    std::string text(sizeof value, '\0');
    std::memcpy(text.data(), &value, sizeof value);
    return text;
}

std::string pc2Header(std::int32_t points, std::int32_t samples, float rate = 1, std::int32_t version = 1)
{
    return std::string("POINTCACHE2\0", 12) + bytes(version) + bytes(points) + bytes(0.0F) + bytes(rate) +
           bytes(samples);
}

/// Frames of three vertices; coordinate c of vertex v in frame f is 100 f + 10 v + c.
std::string pc2(std::int32_t frames, float rate = 1)
{
    auto file = pc2Header(3, frames, rate);
    for (int f = 0; f < frames; ++f) {
        for (int v = 0; v < 3; ++v) {
            for (int c = 0; c < 3; ++c)
                file += bytes(static_cast<float>(100 * f + 10 * v + c));
        }
    }
    return file;
}

using Pc2 = FolderTest;

} // namespace

TEST_F(Pc2, TakesFacesFromTheMesh)
{
    const auto mesh = write("base/body.obj", triangle);
    const auto result = openSequences(write("walk.pc2", pc2(4)), {.mesh = mesh, .fps = 30});
    const auto& sequence = result.sequences.at(0);
    EXPECT_EQ(sequence.name, "walk");
    EXPECT_EQ(sequence.frameCount(), 4);
    EXPECT_EQ(sequence.fps, 30);
    EXPECT_FALSE(result.hasOwnFps);
    EXPECT_EQ(sequence.topology->triangles().size(), 1U);
    EXPECT_EQ(positionsOf(sequence, 3)[2], Vec3f(320, 321, 322));
}

TEST_F(Pc2, FindsTheMeshBesideIt)
{
    const auto file = write("walk.pc2", pc2(2));
    EXPECT_EQ(errorOf([&] { openSequences(file); }).code(), ErrorCode::FormatNeedsMesh);
    write("any.obj", triangle);
    EXPECT_TRUE(hasIssue(openSequences(file).issues, Issue::Code::MeshFound));
    write("other.obj", triangle);
    EXPECT_EQ(errorOf([&] { openSequences(file); }).code(), ErrorCode::FormatNeedsMesh);
    write("mesh.obj", std::string(triangle) + "v 1 1 1\n");
    const auto mismatch = errorOf([&] { openSequences(file); });
    EXPECT_EQ(mismatch.code(), ErrorCode::VertexCountMismatch);
    EXPECT_EQ(mismatch.context().file, folder() / "mesh.obj");
    write("walk.obj", triangle);
    const auto result = openSequences(file);
    ASSERT_TRUE(hasIssue(result.issues, Issue::Code::MeshFound));
    EXPECT_THAT(result.issues.front().toString(), HasSubstr("walk.obj"));
}

TEST_F(Pc2, TakesOfOneMeshReadItOnce)
{
    const auto mesh = write("mesh.obj", triangle);
    write("walk.pc2", pc2(2));
    write("run.pc2", pc2(3));
    const auto topologyOf = [&](const char* name) {
        return openSequences(folder() / name, {.mesh = mesh}).sequences.front().topology;
    };
    auto walk = topologyOf("walk.pc2");
    EXPECT_EQ(topologyOf("run.pc2"), walk);
    EXPECT_EQ(readBaseMesh(mesh).topology, walk);
    // Another file of the same name is another mesh …
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 2 1\n\n");
    const auto turned = topologyOf("walk.pc2");
    EXPECT_NE(turned, walk);
    EXPECT_NE(turned->data().triangles, walk->data().triangles);
    // … and what nobody holds is let go.
    const std::weak_ptr<const Topology> held = walk;
    walk.reset();
    EXPECT_TRUE(held.expired());
}

TEST_F(Pc2, TakesOnlyARealRate)
{
    write("mesh.obj", triangle);
    for (const float rate : {1.0F, 0.0F, -3.0F, 1e9F, std::numeric_limits<float>::quiet_NaN()}) {
        const auto result = openSequences(write("a.pc2", pc2(2, rate)), {.fps = 50});
        EXPECT_FALSE(result.hasOwnFps) << rate;
        EXPECT_EQ(result.sequences[0].fps, 50);
        EXPECT_TRUE(hasIssue(result.issues, Issue::Code::FpsAssumed));
    }
    const auto result = openSequences(write("a.pc2", pc2(2, 24)), {.fps = 50});
    EXPECT_TRUE(result.hasOwnFps);
    EXPECT_EQ(result.sequences[0].fps, 24);
    EXPECT_FALSE(hasIssue(result.issues, Issue::Code::FpsAssumed));
}

TEST_F(Pc2, RefusesBadFiles)
{
    struct Case
    {
        std::string content;
        ErrorCode code;
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<Case> cases{
        {"", ErrorCode::FileEmpty},
        {"POINTCACHE2", ErrorCode::FileTruncated},
        {pc2(4).substr(0, 32 + 3 * 36 + 35), ErrorCode::FileTruncated},
        {"XOINTCACHE2" + pc2(1).substr(11), ErrorCode::FileSyntax},
        {pc2Header(3, 1, 1, 2) + std::string(36, '\0'), ErrorCode::FileSyntax},
        {pc2Header(0x7FFFFFFF, 0x7FFFFFFF) + std::string(36, '\0'), ErrorCode::CountTooLarge},
        {pc2Header(3, 0x7FFFFFFF) + std::string(36, '\0'), ErrorCode::FileTruncated},
        {pc2Header(-3, 1) + std::string(36, '\0'), ErrorCode::NoVertices},
        {pc2Header(0, 1) + std::string(36, '\0'), ErrorCode::NoVertices},
        {pc2Header(3, 0) + std::string(36, '\0'), ErrorCode::FileSyntax},
        {pc2Header(3, -1) + std::string(36, '\0'), ErrorCode::FileSyntax},
        {pc2(1) + "", ErrorCode::Cancelled}, // stands for no error
        {pc2Header(3, 1) + bytes(nan) + std::string(32, '\0'), ErrorCode::NonFiniteCoordinate},
    };
    write("mesh.obj", triangle);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto file = write("bad.pc2", cases[i].content);
        if (cases[i].code == ErrorCode::Cancelled) {
            EXPECT_NO_THROW(openSequences(file));
            continue;
        }
        const auto error = errorOf([&] { openSequences(file); });
        EXPECT_EQ(error.code(), cases[i].code) << i << ": " << error.what();
        EXPECT_EQ(error.context().file, file) << i;
    }
}

TEST_F(Pc2, SaysWhereItIsCut)
{
    write("mesh.obj", triangle);
    const auto error = errorOf([&] { openSequences(write("cut.pc2", pc2(4).substr(0, 32 + 2 * 36 + 7))); });
    EXPECT_EQ(error.code(), ErrorCode::FileTruncated);
    EXPECT_EQ(error.context().place.frame, FrameIndex(2));
    EXPECT_EQ(valueOf(error, "expected"), "4 frames");
}

TEST_F(Pc2, NamesTheFrameOfABadCoordinate)
{
    write("mesh.obj", triangle);
    auto content = pc2(3);
    const auto infinite = bytes(std::numeric_limits<float>::infinity());
    content.replace(32 + 36 + 12, 4, infinite);
    const auto sequence = openSequences(write("bad.pc2", content)).sequences.at(0);
    const auto error = errorOf([&] { sequence.frame(FrameIndex(1)); });
    EXPECT_EQ(error.code(), ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(error.context().place.frame, FrameIndex(1));
    EXPECT_EQ(valueOf(error, "vertex"), "1");
    EXPECT_EQ(error.context().file, folder() / "bad.pc2");
}

TEST_F(Pc2, IsWrittenAsItWasRead)
{
    write("mesh.obj", triangle);
    const auto content = pc2(7);
    const auto sequence = openSequences(write("a.pc2", content)).sequences.at(0);
    const auto result = exportSequence(sequence, folder() / "new" / "b.pc2");
    EXPECT_EQ(result.files, std::vector{folder() / "new" / "b.pc2"});
    EXPECT_EQ(read(folder() / "new" / "b.pc2"), content);
    exportSequence(sequence, folder() / "c.pc2", {.range = FrameRange{FrameIndex(2), FrameIndex(3)}});
    EXPECT_EQ(read(folder() / "c.pc2"), pc2Header(3, 2) + content.substr(32 + 72, 72));
}

TEST_F(Pc2, ACancelledExportLeavesNothing)
{
    write("mesh.obj", triangle);
    const auto sequence = openSequences(write("a.pc2", pc2(7))).sequences.at(0);
    CancelToken token;
    token.cancel();
    const auto error = errorOf([&] { exportSequence(sequence, folder() / "b.pc2", {}, Progress(token)); });
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    EXPECT_EQ(names(folder()), (std::vector<std::string>{"a.pc2", "mesh.obj"}));
}

TEST_F(Pc2, OpensFourGigabytesWithLittleMemory)
{
    // A sparse file: 4.3 GB of which only three frames are on the disk. Their offsets need more than 32 bits.
    constexpr std::int32_t points = 10'000;
    constexpr std::int32_t samples = 36'000;
    constexpr std::uint64_t frameBytes = std::uint64_t{12} * points;
    const auto file = write("large.pc2", pc2Header(points, samples));
    std::error_code unable;
    std::filesystem::resize_file(file, 32 + frameBytes * samples, unable);
    if (unable)
        GTEST_SKIP() << "no sparse files here";
    const std::vector<std::int32_t> marked{0, samples / 2, samples - 1};
    {
        std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
        for (const std::int32_t frame : marked) {
            out.seekp(
                static_cast<std::streamoff>(32 + frameBytes * (static_cast<std::uint64_t>(frame) + 1) - 4));
            out << bytes(static_cast<float>(frame) + 1);
        }
    }
    std::string mesh;
    for (std::int32_t v = 0; v < points; ++v)
        mesh += "v " + std::to_string(v) + " 0 0\n";
    write("mesh.obj", mesh + "f 1 2 3\n");
    const auto peakKilobytes = [] {
        rusage usage{};
        ::getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const auto before = peakKilobytes();
    const auto sequence = openSequences(file).sequences.at(0);
    ASSERT_EQ(sequence.frameCount(), samples);
    MediaCache cache(std::size_t{64} << 20U);
    for (const std::int32_t frame : marked)
        EXPECT_EQ(sequence.frame(FrameIndex(frame), cache).positions().back().z(),
                  static_cast<float>(frame) + 1);
    for (std::int32_t frame = 0; frame < samples; frame += 17) { // 254 MB, scrubbed over
        sequence.frame(FrameIndex(frame), cache);
        ASSERT_LE(cache.statistics().bytes, cache.statistics().budget);
    }
    EXPECT_GT(cache.statistics().items, 500U);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LT(peakKilobytes() - before, 150'000); // a sanitizer keeps what is freed
#else
    EXPECT_GE(peakKilobytes(), before);
#endif
}

TEST_F(Pc2, AFolderOfCachesIsNotASeries)
{
    write("mesh.obj", triangle);
    write("take_1.pc2", pc2(1));
    write("take_2.pc2", pc2(1));
    EXPECT_EQ(errorOf([&] { openSequences(folder() / "take_#.pc2"); }).code(), ErrorCode::SeriesAmbiguous);
}
