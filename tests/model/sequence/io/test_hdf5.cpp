// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/hdf5.h"
#include "model/sequence/io/hdf5sequence.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <gmock/gmock.h>
#include <tbb/parallel_for.h>

using namespace quadrille;

namespace {

ImportResult openFaust(const std::filesystem::path& path, const std::string& clip = {})
{
    ImportOptions options;
    options.clip = clip;
    return Hdf5Importer().open(fileSource(path), options, {});
}

void addDataset(const Hdf5Handle& file, const char* name, std::vector<hsize_t> size, hid_t type,
                const void* values)
{
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
    const Hdf5Handle dataset(
        H5Dcreate2(file.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    if (values)
        H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
}

Hdf5Handle create(const std::filesystem::path& path)
{
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
}

/// Coordinate of a frame in the test files.
float value(hsize_t frame, hsize_t vertex, hsize_t axis)
{
    return static_cast<float>(frame * 1000 + vertex * 3 + axis);
}

constexpr hsize_t vertices = 4;
constexpr hsize_t frames = 5;

/// A file as Dynamic FAUST has them, with a second sequence frames × vertices × 3.
std::filesystem::path writeFaust(const std::filesystem::path& path,
                                 std::vector<std::int32_t> faces = {0, 1, 2, 0, 2, 3})
{
    const auto lock = lockHdf5();
    const Hdf5Handle file = create(path);
    std::vector<float> last(vertices * 3 * frames);
    std::vector<float> first(last.size());
    for (hsize_t f = 0; f < frames; ++f) {
        for (hsize_t i = 0; i < vertices * 3; ++i) {
            last[i * frames + f] = value(f, i / 3, i % 3);
            first[f * vertices * 3 + i] = value(f, i / 3, i % 3);
        }
    }
    addDataset(file, "50002_walk", {vertices, 3, frames}, H5T_NATIVE_FLOAT, last.data());
    addDataset(file, "by_frame", {frames, vertices, 3}, H5T_NATIVE_FLOAT, first.data());
    addDataset(file, "faces", {faces.size() / 3, 3}, H5T_NATIVE_INT32, faces.data());
    return path;
}

} // namespace

TEST(Hdf5, EachDatasetBecomesASequence)
{
    const TemporaryFolder folder;
    const ImportResult result = openFaust(writeFaust(folder / "registrations.hdf5"));
    ASSERT_EQ(result.sequences.size(), 2U);
    EXPECT_EQ(result.sequences[0].name, "50002_walk");
    EXPECT_EQ(result.sequences[1].name, "by_frame");
    EXPECT_EQ(result.sequences[0].topology, result.sequences[1].topology);
    EXPECT_EQ(result.sequences[0].topology->triangles().size(), 2U);
    for (const MeshSequence& sequence : result.sequences) {
        ASSERT_EQ(sequence.frameCount(), static_cast<std::int64_t>(frames));
        for (hsize_t f = 0; f < frames; ++f) {
            const Frame frame = sequence.frame(FrameIndex(f));
            for (hsize_t v = 0; v < vertices; ++v)
                EXPECT_EQ(frame.positions()[v], Vec3f(value(f, v, 0), value(f, v, 1), value(f, v, 2)));
        }
    }
    EXPECT_EQ(openFaust(folder / "registrations.hdf5", "by_frame").sequences.size(), 1U);
    EXPECT_EQ(codeOf([&] { openFaust(folder / "registrations.hdf5", "none"); }), ErrorCode::BadArgument);
}

TEST(Hdf5, FramesAreReadFromManyThreads)
{
    const TemporaryFolder folder;
    const auto path = folder / "long.h5";
    const hsize_t manyFrames = 400;
    const hsize_t manyVertices = 3000; // several blocks
    {
        const auto lock = lockHdf5();
        const Hdf5Handle file = create(path);
        std::vector<float> values(manyVertices * 3 * manyFrames);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<float>(i % manyFrames);
        addDataset(file, "take", {manyVertices, 3, manyFrames}, H5T_NATIVE_FLOAT, values.data());
        const std::vector<std::int32_t> faces{0, 1, 2};
        addDataset(file, "faces", {1, 3}, H5T_NATIVE_INT32, faces.data());
    }
    const ImportResult result = openFaust(path);
    const auto& source = *result.sequences.at(0).source;
    std::atomic<int> wrong{0};
    tbb::parallel_for(std::int64_t{0}, std::int64_t{400}, [&](std::int64_t i) {
        const std::int64_t frame = i * 37 % 400;
        std::vector<Vec3f> out(source.vertexCount());
        source.read(FrameIndex(frame), out);
        for (const Vec3f& p : out)
            wrong += p != Vec3f::Constant(static_cast<float>(frame));
    });
    EXPECT_EQ(wrong, 0);
}

TEST(Hdf5, BadFilesAreRefused)
{
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { openFaust(folder / "none.h5"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { openFaust(folder.write("empty.h5", "")); }), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOf([&] { openFaust(folder.write("text.h5", "not HDF5 at all")); }), ErrorCode::FileSyntax);
    const auto whole = writeFaust(folder / "whole.h5");
    const FileContent content = readFile(whole);
    const auto cut = folder.write("cut.h5", std::string(content.text().substr(0, content.size / 2)));
    EXPECT_EQ(codeOf([&] { openFaust(cut); }), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf([&] {
                  openFaust(writeFaust(folder / "outside.h5", {0, 1, 9}));
              }),
              ErrorCode::IndexOutOfRange);
    EXPECT_EQ(codeOf([&] {
                  openFaust(writeFaust(folder / "negative.h5", {0, 1, -1}));
              }),
              ErrorCode::IndexOutOfRange);
}

TEST(Hdf5, MissingPartsAreNamed)
{
    const TemporaryFolder folder;
    const std::vector<float> values(12, 0.0F);
    const std::vector<std::int32_t> faces{0, 1, 2};
    {
        const auto lock = lockHdf5();
        addDataset(create(folder / "nofaces.h5"), "take", {4, 3, 1}, H5T_NATIVE_FLOAT, values.data());
        addDataset(create(folder / "notakes.h5"), "faces", {1, 3}, H5T_NATIVE_INT32, faces.data());
        const Hdf5Handle absurd = create(folder / "absurd.h5");
        // Space for the values is never taken: contiguous storage is allocated when written.
        addDataset(absurd, "take", {100000000, 3, 1000000}, H5T_NATIVE_FLOAT, nullptr);
        addDataset(absurd, "faces", {1, 3}, H5T_NATIVE_INT32, faces.data());
    }
    EXPECT_EQ(codeOf([&] { openFaust(folder / "nofaces.h5"); }), ErrorCode::NoFaces);
    EXPECT_EQ(codeOf([&] { openFaust(folder / "notakes.h5"); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([&] { openFaust(folder / "absurd.h5"); }), ErrorCode::CountTooLarge);
}
