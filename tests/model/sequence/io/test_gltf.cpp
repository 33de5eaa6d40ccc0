// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/gltf.h"
#include "tests/model/sequence/io/glbbuilder.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <cmath>
#include <gmock/gmock.h>
#include <map>

using namespace quadrille;

namespace {

ImportResult open(const std::filesystem::path& path, double fps = 30, const std::string& clip = {})
{
    ImportOptions options;
    options.fps = fps;
    options.clip = clip;
    return GltfImporter().open(fileSource(path), options, {});
}

const MeshSequence& named(const ImportResult& result, const std::string& name)
{
    for (const MeshSequence& sequence : result.sequences)
        if (sequence.name == name)
            return sequence;
    throw std::runtime_error("no sequence " + name);
}

} // namespace

TEST(Gltf, TheFoxEqualsItsPointCaches)
{
    const auto file = dataDirectory() / "raw/fox-animations.glb";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no data";
    const ImportResult result = open(file);
    ASSERT_EQ(result.sequences.size(), 14U);
    const Topology& topology = *result.sequences.front().topology;
    EXPECT_EQ(topology.vertexCount(), 833U);
    EXPECT_EQ(topology.triangles().size(), 1654U);
    EXPECT_TRUE(topology.hasUvs());
    EXPECT_EQ(topology.statistics().components, 3);
    EXPECT_TRUE(topology.isClosed());
    for (const char* take : {"Bite", "Howl", "Idle", "Jump", "Run", "Sit", "Sneak", "Walk"}) {
        std::string lower = take;
        lower[0] = static_cast<char>(std::tolower(lower[0]));
        const auto expected = readPointCache(dataDirectory() / ("characters/fox/" + lower + ".pc2"));
        const MeshSequence& sequence = named(result, take);
        ASSERT_EQ(sequence.frameCount(), static_cast<std::int64_t>(expected.frames)) << take;
        const auto frames = loadFrames(sequence);
        ASSERT_EQ(frames.size(), expected.positions.size());
        float largest = 0;
        for (std::size_t i = 0; i < frames.size(); ++i)
            largest = std::max(largest, (frames[i] - expected.positions[i]).norm());
        EXPECT_LT(largest, 1e-5F * sizeOf(frames)) << take;
    }
    const auto texture = result.sequences.front().texture(FrameIndex(0));
    ASSERT_TRUE(texture);
    EXPECT_GT(texture->width, 1);
    EXPECT_EQ(result.sequences.front().textures.kind(), TextureSet::Kind::Single);
}
