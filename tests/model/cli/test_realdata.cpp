// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"
#include "model/project/json/jsontext.h"
#include "model/render/camera.h"
#include "model/sequence/io/registry.h"
#include "tests/model/cli/runquadrille.h"

#include <algorithm>
#include <gmock/gmock.h>

using namespace quadrille;
using namespace quadrille::test;
namespace fs = std::filesystem;

namespace {

const fs::path dataFolder = QUADRILLE_DATA_DIR;

/// A row of the data's README.
struct Character
{
    const char* name;
    int vertices;
    int triangles;
    int frames;
    int takes;
    int components;
    int boundaryEdges;
    int boundaryLoops;
    int euler;
};

const Character characters[] = {
    {"liam", 10000, 20000, 125, 3, 1, 0, 0, 0}, {"rb_m04", 3874, 7744, 1150, 21, 1, 0, 0, 2},
    {"rb_f01", 3908, 7812, 163, 4, 1, 0, 0, 2}, {"mh_male", 1541, 3052, 246, 6, 1, 32, 3, -1},
    {"fox", 833, 1654, 325, 8, 3, 0, 0, 6},
};

std::vector<std::string> takesOf(const std::string& character)
{
    std::vector<std::string> takes;
    for (const auto& entry : fs::directory_iterator(dataFolder / "characters" / character)) {
        if (entry.path().extension() == ".pc2")
            takes.push_back(entry.path().string());
    }
    std::sort(takes.begin(), takes.end());
    return takes;
}

class RealData : public ::testing::Test
{
protected:
    void SetUp() override
    {
        if (!fs::exists(dataFolder / "characters"))
            GTEST_SKIP() << "no data in " << dataFolder;
    }
    TemporaryFolder folder;
};

} // namespace

TEST_F(RealData, InfoAgreesWithTheReadme)
{
    for (const Character& character : characters) {
        std::vector<std::string> arguments{"info", "--json", "--mesh",
                                           dataFolder / "characters" / character.name / "mesh.obj"};
        const auto takes = takesOf(character.name);
        arguments.insert(arguments.end(), takes.begin(), takes.end());
        const Outcome run = runQuadrille(arguments, folder.path());
        ASSERT_EQ(run.status, 0) << run.err;
        int frames = 0;
        const Json list = Json::parse(run.out);
        EXPECT_EQ(list.size(), static_cast<std::size_t>(character.takes)) << character.name;
        for (const Json& take : list) {
            frames += take["frames"].get<int>();
            EXPECT_EQ(take["vertices"], character.vertices) << character.name;
            EXPECT_EQ(take["triangles"], character.triangles) << character.name;
            EXPECT_EQ(take["components"], character.components) << character.name;
            EXPECT_EQ(take["boundary_edges"], character.boundaryEdges) << character.name;
            EXPECT_EQ(take["boundary_loops"], character.boundaryLoops) << character.name;
            EXPECT_EQ(take["euler"], character.euler) << character.name;
            EXPECT_EQ(take["non_manifold_edges"], 0) << character.name;
            EXPECT_EQ(take["uvs"], true) << character.name;
        }
        EXPECT_EQ(frames, character.frames) << character.name;
    }
}

TEST_F(RealData, AllTakesOfOneCharacterAreImported)
{
    std::vector<std::string> arguments{"import", "man.quadrille"};
    const auto takes = takesOf("rb_m04");
    arguments.insert(arguments.end(), takes.begin(), takes.end());
    for (const std::string& more :
         {std::string("--mesh"), std::string(dataFolder / "characters/rb_m04/mesh.obj"), std::string("--fps"),
          std::string("30")})
        arguments.push_back(more);
    const Outcome imported = runQuadrille(arguments, folder.path());
    ASSERT_EQ(imported.status, 0) << imported.err;
    const Project project = loadProject(folder / "man.quadrille");
    EXPECT_EQ(project.sequences.size(), 21U);
    EXPECT_EQ(project.settings.fps, 30);
    EXPECT_EQ(project.characters.size(), 1U);
    EXPECT_EQ(runQuadrille({"check", "man.quadrille"}, folder.path()).status, 0);
    ASSERT_EQ(runQuadrille({"rebuild", "man.quadrille"}, folder.path()).status, 0);
    ASSERT_EQ(runQuadrille({"data", "man.quadrille", "frames", "-o", "frames.csv"}, folder.path()).status, 0);
    const std::string csv = textOf(folder / "frames.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1151);
}

TEST_F(RealData, EachFrameOfTheCaptureHasItsTexture)
{
    const Outcome run =
        runQuadrille({"info", "--json", (dataFolder / "characters/liam/talk_a.pc2").string()}, folder.path());
    ASSERT_EQ(run.status, 0) << run.err;
    const Json info = Json::parse(run.out)[0];
    EXPECT_EQ(info["textures"]["kind"], "per_frame");
    EXPECT_EQ(info["textures"]["count"], 50);
}

TEST_F(RealData, RoundTripsKeepVerticesAndTheirPlaces)
{
    const fs::path take = dataFolder / "characters/mh_male/m_avg__walk.pc2";
    ImportOptions options;
    options.mesh = dataFolder / "characters/mh_male/mesh.obj";
    const MeshSequence source = openSequences(take, options).sequences.front();
    const auto size = [](const MeshSequence& sequence) {
        const Bounds bounds = boundsOf(sequence.frame(FrameIndex(0)).positions());
        return bounds.size().norm();
    };
    const auto expectSame = [&](const MeshSequence& other, const char* format) {
        ASSERT_EQ(other.frameCount(), source.frameCount()) << format;
        EXPECT_EQ(other.topology->triangles(), source.topology->triangles()) << format;
        double largest = 0;
        for (std::int64_t f = 0; f < source.frameCount(); ++f) {
            const Frame a = source.frame(FrameIndex(f));
            const Frame b = other.frame(FrameIndex(f));
            for (std::size_t v = 0; v < a.positions().size(); ++v)
                largest =
                    std::max(largest, static_cast<double>((a.positions()[v] - b.positions()[v]).norm()));
        }
        EXPECT_LE(largest, 1e-6 * size(source)) << format;
    };
    exportSequence(source, folder / "obj/walk.obj");
    const auto obj = openSequences(folder / "obj").sequences.front();
    expectSame(obj, "OBJ");
    exportSequence(obj, folder / "walk.pc2");
    options.mesh = folder / "obj/walk_0000.obj";
    const auto cache = openSequences(folder / "walk.pc2", options).sequences.front();
    expectSame(cache, "PC2");
    exportSequence(cache, folder / "ply/walk.ply");
    const auto ply = openSequences(folder / "ply").sequences.front();
    expectSame(ply, "PLY");
    exportSequence(ply, folder / "again/walk.obj");
    expectSame(openSequences(folder / "again").sequences.front(), "OBJ again");
    exportSequence(source, folder / "walk.glb");
    ImportOptions rate;
    rate.fps = source.fps;
    expectSame(openSequences(folder / "walk.glb", rate).sequences.front(), "GLB");
}

TEST_F(RealData, RawSeriesEqualTheirPointCache)
{
    ImportOptions options;
    options.mesh = dataFolder / "characters/mh_male/mesh.obj";
    const MeshSequence cache =
        openSequences(dataFolder / "characters/mh_male/m_avg__walk.pc2", options).sequences.front();
    for (const char* name : {"raw/seq_m_avg_walk_obj", "raw/seq_m_avg_walk_ply"}) {
        const MeshSequence series = openSequences(dataFolder / name).sequences.front();
        ASSERT_EQ(series.frameCount(), 6) << name;
        EXPECT_EQ(series.topology->triangles(), cache.topology->triangles()) << name;
        for (std::int64_t f = 0; f < 6; ++f) {
            const Frame a = series.frame(FrameIndex(f));
            const Frame b = cache.frame(FrameIndex(f));
            for (std::size_t v = 0; v < a.positions().size(); ++v)
                ASSERT_LT((a.positions()[v] - b.positions()[v]).norm(), 1e-6F) << name << ", vertex " << v;
        }
    }
}

TEST_F(RealData, EachScanOpens)
{
    const std::vector<std::tuple<const char*, std::uint32_t, std::size_t>> scans{
        {"scans/liam_frame112", 26585, 53164},
        {"scans/makehuman_m_muscle.ply", 53514, 107024},
        {"scans/human_man.ply", 6890, 13776},
        {"scans/statue_DancingGirl.ply", 9641, 19294},
    };
    for (const auto& [name, vertices, triangles] : scans) {
        const MeshSequence scan = openSequences(dataFolder / name).sequences.front();
        EXPECT_EQ(scan.topology->vertexCount(), vertices) << name;
        EXPECT_EQ(scan.topology->triangles().size(), triangles) << name;
    }
}

TEST_F(RealData, WhatCannotBeReadSaysWhatToConvertItTo)
{
    const std::vector<std::pair<const char*, const char*>> refused{
        {"raw/dem_bones_Bone_Anim.abc", "Alembic cannot be read here. Open it in Blender"},
        {"raw/cmu_02_01.bvh", "A skeleton without a mesh (BVH)"},
        {"raw/cmu_02.asf", "A skeleton without a mesh (Acclaim)"},
        {"raw/liam_draco_ktx2", "Draco compressed meshes cannot be read here. Decode them"},
    };
    for (const auto& [name, sentence] : refused) {
        const Outcome run = runQuadrille({"info", (dataFolder / name).string()}, folder.path());
        EXPECT_EQ(run.status, 1) << name;
        EXPECT_THAT(run.err, ::testing::HasSubstr(sentence)) << name;
    }
}
