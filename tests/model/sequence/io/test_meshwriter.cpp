// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "fixture.h"
#include "testsequence.h"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gmock/gmock.h>

using namespace quadrille;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

namespace {

class MeshWriter : public FolderTest, public ::testing::WithParamInterface<std::string>
{
public:
    std::filesystem::path out(const std::string& name) const { return folder() / (name + GetParam()); }
};

MeshSequence textured(TextureSet textures)
{
    MeshSequence sequence = wanderingPyramid(3);
    sequence.textures = std::move(textures);
    return sequence;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Formats, MeshWriter, ::testing::Values(".obj", ".ply"),
                         [](const auto& format) { return format.param.substr(1); });

TEST_P(MeshWriter, WritesNumberedFilesThatReadBackTheSame)
{
    const MeshSequence sequence = wanderingPyramid(3);
    const auto written = exportSequence(sequence, out("new/p"));
    EXPECT_THAT(names(folder() / "new"),
                ElementsAre("p_0000" + GetParam(), "p_0001" + GetParam(), "p_0002" + GetParam()));
    EXPECT_EQ(written.files.size(), 3U);
    ImportOptions options;
    options.fps = 24;
    const auto back = openSequences(folder() / "new", options).sequences.at(0);
    EXPECT_EQ(back.topology->triangles(), sequence.topology->triangles());
    for (std::int64_t f = 0; f < 3; ++f)
        EXPECT_EQ(positionsOf(back, f), positionsOf(sequence, f)) << "bit by bit";
    const TopologyData& data = sequence.topology->data();
    const TopologyData& read = back.topology->data();
    ASSERT_EQ(read.triangleUvs.size(), data.triangleUvs.size());
    for (std::size_t t = 0; t < data.triangleUvs.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(read.uvs[read.triangleUvs[t][c]], data.uvs[data.triangleUvs[t][c]]);
    }
}

TEST_P(MeshWriter, AssimpReadsTheSame)
{
    const MeshSequence sequence = wanderingPyramid(2);
    const auto written = exportSequence(sequence, out("p"));
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(written.files.at(1).string(),
                                             aiProcess_Triangulate | aiProcess_PreTransformVertices);
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    const auto positions = positionsOf(sequence, 1);
    std::size_t triangles = 0;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f, ++triangles) {
            for (unsigned c = 0; c < 3; ++c) {
                const aiVector3D& p = mesh.mVertices[mesh.mFaces[f].mIndices[c]];
                EXPECT_TRUE(std::any_of(positions.begin(), positions.end(), [&p](const Vec3f& q) {
                    return (q - Vec3f(p.x, p.y, p.z)).norm() < 1e-6F;
                }));
            }
        }
    }
    EXPECT_EQ(triangles, sequence.topology->triangles().size());
}

TEST_P(MeshWriter, CarriesOneTexture)
{
    exportSequence(textured(TextureSet::single({{}, plainImage(40)})), out("p"));
    const auto back = openSequences(folder() / ("p_####" + GetParam())).sequences.at(0);
    EXPECT_TRUE(std::filesystem::exists(folder() / "p_texture.png"));
    for (int material = 0; material < 2; ++material) {
        const auto picture = back.texture(FrameIndex(1), material);
        ASSERT_NE(picture, nullptr);
        EXPECT_EQ(*picture, *plainImage(40));
    }
}

TEST_P(MeshWriter, CarriesATextureForEachMaterial)
{
    exportSequence(textured(TextureSet::perMaterial({{{}, plainImage(10)}, {{}, plainImage(20)}})), out("p"));
    const auto back = openSequences(folder() / ("p_####" + GetParam())).sequences.at(0);
    ASSERT_EQ(back.textures.kind(), TextureSet::Kind::PerMaterial);
    EXPECT_EQ(*back.texture(FrameIndex(0), 0), *plainImage(10));
    EXPECT_EQ(*back.texture(FrameIndex(0), 1), *plainImage(20));
    EXPECT_EQ(back.topology->data().triangleMaterials,
              wanderingPyramid(1).topology->data().triangleMaterials);
}

TEST_P(MeshWriter, CarriesTexturesThatChange)
{
    exportSequence(
        textured(TextureSet::perFrame({{{}, plainImage(1)}, {{}, plainImage(2)}, {{}, plainImage(3)}})),
        out("p"));
    const auto back = openSequences(folder() / ("p_####" + GetParam())).sequences.at(0);
    ASSERT_EQ(back.textures.kind(), TextureSet::Kind::PerFrame);
    EXPECT_EQ(*back.texture(FrameIndex(2)), *plainImage(3));
    // Each file alone wears its picture, too.
    const auto alone = openSequences(folder() / ("p_0001" + GetParam())).sequences.at(0);
    ASSERT_NE(alone.texture(FrameIndex(0)), nullptr);
    EXPECT_EQ(*alone.texture(FrameIndex(0)), *plainImage(2));
}

TEST_P(MeshWriter, WritesNoTexturesWhenNotAskedTo)
{
    ExportOptions options;
    options.textures = false;
    exportSequence(textured(TextureSet::single({{}, plainImage(40)})), out("p"), options);
    EXPECT_EQ(names(folder()).size(), 3U);
    EXPECT_THAT(read(folder() / ("p_0000" + GetParam())), Not(HasSubstr("texture")));
}

TEST_P(MeshWriter, LeavesNothingWhenItIsCancelled)
{
    CancelToken cancel;
    const Progress progress(cancel, [&cancel](double fraction) {
        if (fraction > 0.3)
            cancel.cancel();
    });
    const auto error = errorOf([&] { exportSequence(wanderingPyramid(50), out("new/p"), {}, progress); });
    EXPECT_EQ(error.code(), ErrorCode::Cancelled);
    EXPECT_FALSE(std::filesystem::exists(folder() / "new"));
}

TEST_P(MeshWriter, SaysWhereItCannotWrite)
{
    const auto blocked = write("file", "not a folder");
    const auto error = errorOf([&] { exportSequence(wanderingPyramid(2), blocked / ("p" + GetParam())); });
    EXPECT_EQ(error.code(), ErrorCode::WriteFailed);
}
