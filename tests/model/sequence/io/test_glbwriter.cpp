// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/render/shading.h"
#include "model/sequence/io/gltf/glbwriter.h"
#include "model/sequence/io/gltf/gltf.h"
#include "tests/model/sequence/io/sceneiotest.h"
#include "tests/model/sequence/io/testsequence.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <set>

using namespace quadrille;

namespace {

ImportResult reopen(const std::filesystem::path& path, double fps)
{
    ImportOptions options;
    options.fps = fps;
    return GltfImporter().open(fileSource(path), options, {});
}

/// Largest distance of two sequences' frames, relative to their size.
float largestError(const MeshSequence& a, const MeshSequence& b)
{
    const auto first = loadFrames(a);
    const auto second = loadFrames(b);
    EXPECT_EQ(first.size(), second.size());
    float largest = 0;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
        largest = std::max(largest, (first[i] - second[i]).norm());
    return largest / sizeOf(first);
}

} // namespace

TEST(GlbWriter, ARoundTripKeepsOrderUvsMaterialsAndPositions)
{
    const TemporaryFolder folder;
    MeshSequence sequence = wanderingPyramid(9);
    sequence.textures = TextureSet::perMaterial({{{}, plainImage(10)}, {{}, plainImage(200)}});
    const auto file = folder / "pyramid.glb";
    const ExportResult written = GlbExporter().write(sequence, file, {}, {});
    EXPECT_THAT(written.files, ::testing::ElementsAre(file));
    EXPECT_TRUE(written.issues.empty());

    const ImportResult result = reopen(file, 24);
    ASSERT_EQ(result.sequences.size(), 1U);
    const MeshSequence& back = result.sequences.front();
    EXPECT_EQ(back.name, "pyramid");
    ASSERT_EQ(back.frameCount(), 9);
    const TopologyData& before = sequence.topology->data();
    const TopologyData& after = back.topology->data();
    ASSERT_EQ(after.vertexCount, 7U);
    ASSERT_EQ(after.triangles.size(), 8U);
    EXPECT_EQ(after.materials, before.materials);
    // Triangles come grouped by material; each keeps its corners and their UVs.
    std::multiset<std::vector<float>> expected;
    std::multiset<std::vector<float>> found;
    const auto collect = [](const TopologyData& data, std::multiset<std::vector<float>>& into) {
        for (std::size_t t = 0; t < data.triangles.size(); ++t) {
            std::vector<float> row{static_cast<float>(data.triangleMaterials[t])};
            for (std::size_t c = 0; c < 3; ++c) {
                const Vec2f uv = data.uvs[data.triangleUvs[t][c]];
                row.insert(row.end(), {static_cast<float>(data.triangles[t][c].value), uv.x(), uv.y()});
            }
            into.insert(row);
        }
    };
    collect(before, expected);
    collect(after, found);
    EXPECT_EQ(found, expected);
    EXPECT_LT(largestError(sequence, back), 1e-6F);
    ASSERT_TRUE(back.texture(FrameIndex(0), 1));
    EXPECT_EQ(*back.texture(FrameIndex(0), 0), *plainImage(10));
    EXPECT_EQ(*back.texture(FrameIndex(0), 1), *plainImage(200));
}

TEST(GlbWriter, OneFrameHasNoAnimation)
{
    const TemporaryFolder folder;
    GlbExporter().write(wanderingPyramid(1), folder / "one.glb", {}, {});
    const ImportResult result = reopen(folder / "one.glb", 30);
    EXPECT_EQ(result.sequences.at(0).frameCount(), 1);
    EXPECT_EQ(result.sequences.at(0).name, "one");
}

TEST(GlbWriter, AssimpReadsTheMorphTargetsAndTheirWeights)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(5);
    GlbExporter().write(sequence, folder / "pyramid.glb", {}, {});
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "pyramid.glb").string(), 0);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 2U);
    ASSERT_EQ(scene->mNumAnimations, 1U);
    const aiAnimation& animation = *scene->mAnimations[0];
    EXPECT_NEAR(animation.mDuration / animation.mTicksPerSecond, 4 / 24.0, 1e-5);
    ASSERT_EQ(animation.mNumMorphMeshChannels, 1U);
    EXPECT_EQ(animation.mMorphMeshChannels[0]->mNumKeys, 5U);
    const aiMesh& upper = *scene->mMeshes[0];
    ASSERT_EQ(upper.mNumAnimMeshes, 4U);
    // The tip is the first vertex of the first part.
    for (int f = 0; f < 5; ++f) {
        const aiVector3D& tip = f == 0 ? upper.mVertices[0] : upper.mAnimMeshes[f - 1]->mVertices[0];
        const Vec3f expected = sequence.frame(FrameIndex(f)).positions()[0];
        EXPECT_LT((Vec3f(tip.x, tip.y, tip.z) - expected).norm(), 1e-6F) << f;
    }
}

TEST(GlbWriter, NormalsTurnWithTheSurfaceInEveryFrame)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(5);
    GlbExporter().write(sequence, folder / "pyramid.glb", {}, {});
    Assimp::Importer importer;
    const aiScene* scene =
        importer.ReadFile((folder / "pyramid.glb").string(), aiProcess_ValidateDataStructure);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    const aiMesh& upper = *scene->mMeshes[0];
    ASSERT_TRUE(upper.HasNormals());
    const IncidentTriangles neighbours =
        trianglesOfVertices(sequence.topology->triangles(), sequence.topology->vertexCount());
    for (int f = 0; f < 5; ++f) {
        // The tip is the first vertex of the first part.
        const Frame frame = sequence.frame(FrameIndex(f));
        const Vec3f expected =
            vertexNormals(frame.positions(), sequence.topology->triangles(), neighbours)[0];
        const aiVector3D& tip = f == 0 ? upper.mNormals[0] : upper.mAnimMeshes[f - 1]->mNormals[0];
        EXPECT_LT((Vec3f(tip.x, tip.y, tip.z) - expected).norm(), 1e-5F) << f;
        EXPECT_NEAR(expected.norm(), 1, 1e-5F);
    }
}

TEST(GlbWriter, NormalsCanBeLeftOut)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(40);
    ExportOptions options;
    options.normals = false;
    GlbExporter().write(sequence, folder / "plain.glb", options, {});
    GlbExporter().write(sequence, folder / "shaded.glb", {}, {});
    const auto plain = std::filesystem::file_size(folder / "plain.glb");
    EXPECT_LT(plain, std::filesystem::file_size(folder / "shaded.glb"));
    EXPECT_GE(estimateGlbBytes(sequence, false), plain);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile((folder / "plain.glb").string(), 0);
    ASSERT_TRUE(scene) << importer.GetErrorString();
    EXPECT_FALSE(scene->mMeshes[0]->HasNormals());
}

TEST(GlbWriter, OtherUnitsAndAxesAreTurnedByANode)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(3);
    ExportOptions options;
    options.to = {UpAxis::Z, 0.01};
    const MeshSequence inCentimetres = transformed(sequence, conversionMatrix({}, options.to));
    GlbExporter().write(inCentimetres, folder / "cm.glb", options, {});
    EXPECT_LT(largestError(sequence, reopen(folder / "cm.glb", 24).sequences.at(0)), 1e-6F);
}

TEST(GlbWriter, WritesTexturesThatChangeBesideTheFile)
{
    const TemporaryFolder folder;
    MeshSequence sequence = wanderingPyramid(3);
    int made = 0;
    const Texture second{.made = [&] {
        ++made;
        return *plainImage(2);
    }};
    sequence.textures = TextureSet::perFrame({{{}, plainImage(1)}, second, second});
    const ExportResult written = GlbExporter().write(sequence, folder / "walk.glb", {}, {});
    EXPECT_EQ(made, 2) << "once for each frame";
    EXPECT_THAT(written.files,
                ::testing::ElementsAre(folder / "walk.glb", folder / "textures/walk/0000.png",
                                       folder / "textures/walk/0001.png", folder / "textures/walk/0002.png"));
    for (int f = 0; f < 3; ++f)
        EXPECT_EQ(readImage(written.files[static_cast<std::size_t>(f) + 1]), *plainImage(f == 0 ? 1 : 2));
    ASSERT_EQ(written.issues.size(), 1U);
    EXPECT_EQ(written.issues[0].severity, Issue::Severity::Info);
    EXPECT_NE(written.issues[0].toString().find("beside it, in textures/walk."), std::string::npos);
    const ImportResult result = reopen(folder / "walk.glb", 24);
    EXPECT_EQ(*result.sequences.at(0).texture(FrameIndex(0)), *plainImage(1));
    EXPECT_EQ(*result.sequences.at(0).texture(FrameIndex(2)), *plainImage(2)) << "they are found again";
    std::filesystem::remove(folder / "textures/walk/0002.png");
    EXPECT_EQ(*reopen(folder / "walk.glb", 24).sequences.at(0).texture(FrameIndex(2)), *plainImage(1))
        << "that of the file, where there is not one for each frame";
    ExportOptions without;
    without.textures = false;
    EXPECT_EQ(GlbExporter().write(sequence, folder / "u.glb", without, {}).files.size(), 1U);
    EXPECT_FALSE(std::filesystem::exists(folder / "textures/u"));
}

TEST(GlbWriter, TheEstimateIsAnUpperBound)
{
    const TemporaryFolder folder;
    const MeshSequence sequence = wanderingPyramid(40);
    GlbExporter().write(sequence, folder / "size.glb", {}, {});
    const auto size = std::filesystem::file_size(folder / "size.glb");
    EXPECT_GE(estimateGlbBytes(sequence), size);
    EXPECT_LE(estimateGlbBytes(sequence), size * 3);
}

TEST(GlbWriter, CancellingLeavesNothing)
{
    const TemporaryFolder folder;
    CancelToken token;
    token.cancel();
    EXPECT_EQ(
        codeOf([&] { GlbExporter().write(wanderingPyramid(4), folder / "c.glb", {}, Progress(token)); }),
        ErrorCode::Cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder / ""));
}

TEST(GlbWriter, ARealCaptureComesBackTheSame)
{
    const auto fox = dataDirectory() / "raw/fox-animations.glb";
    if (!std::filesystem::exists(fox))
        GTEST_SKIP() << "no data";
    const TemporaryFolder folder;
    const MeshSequence walk = reopen(fox, 30).sequences.at(5);
    GlbExporter().write(walk, folder / "fox.glb", {}, {});
    const MeshSequence back = reopen(folder / "fox.glb", 30).sequences.at(0);
    EXPECT_EQ(back.topology->data().triangles, walk.topology->data().triangles);
    ASSERT_EQ(back.frameCount(), walk.frameCount());
    EXPECT_LT(largestError(walk, back), 1e-6F);
}
