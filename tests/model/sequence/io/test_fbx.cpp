// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/registry.h"
#include "model/sequence/io/scene/assimpscene.h"
#include "model/sequence/io/scene/fbxgeometry.h"
#include "tests/model/sequence/io/meshbytes.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <gmock/gmock.h>

using namespace quadrille;

namespace {

ImportResult openFbx(const std::filesystem::path& path)
{
    ImportOptions options;
    options.fps = 30;
    return FbxImporter().open(fileSource(path), options, {});
}

std::filesystem::path rocketbox()
{
    return dataDirectory() / "raw/Male_Adult_04.fbx";
}

} // namespace

TEST(Fbx, ASkinnedManOpensWithTheControlPointsOfTheFile)
{
    if (!std::filesystem::exists(rocketbox()))
        GTEST_SKIP() << "no data";
    const ImportResult result = openFbx(rocketbox());
    ASSERT_EQ(result.sequences.size(), 1U);
    const MeshSequence& sequence = result.sequences.front();
    EXPECT_EQ(sequence.name, "Take 001");
    EXPECT_EQ(sequence.frameCount(), 2);
    EXPECT_EQ(sequence.topology->vertexCount(), 4752U);
    EXPECT_EQ(sequence.topology->triangles().size(), 8684U);
    EXPECT_EQ(sequence.topology->data().materials.size(), 3U);
    EXPECT_TRUE(sequence.topology->hasUvs());
    ASSERT_TRUE(result.coordinates);
    EXPECT_EQ(result.coordinates->up, UpAxis::Y);
    EXPECT_DOUBLE_EQ(result.coordinates->metresPerUnit, 0.01);

    const auto geometries = readFbxGeometries(readFile(rocketbox()).bytes());
    ASSERT_EQ(geometries.size(), 1U);
    const auto& points = geometries.front().controlPoints;
    ASSERT_EQ(points.size(), 4752U * 3);
    // The control points lie with z up; the skeleton's pose is the same one with y up.
    const Frame frame = sequence.frame(FrameIndex(0));
    const auto positions = frame.positions();
    float largest = 0;
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Vec3d p(points.data() + v * 3);
        const Vec3f expected = Vec3d(p.x(), p.z(), -p.y()).cast<float>();
        largest = std::max(largest, (positions[v] - expected).norm());
    }
    EXPECT_LT(largest, 1e-3F * sizeOf(positions));
    // The colour maps are not beside the file, and that is said.
    EXPECT_EQ(std::count_if(result.issues.begin(), result.issues.end(),
                            [](const Issue& i) { return i.code == Issue::Code::TextureMissing; }),
              3);
}

TEST(Fbx, TheRegistryTurnsCentimetresToMetres)
{
    if (!std::filesystem::exists(rocketbox()))
        GTEST_SKIP() << "no data";
    const ImportResult result = openSequences(rocketbox());
    const Frame frame = result.sequences.at(0).frame(FrameIndex(0));
    Vec3f low = frame.positions()[0];
    Vec3f high = low;
    for (const Vec3f& p : frame.positions()) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    EXPECT_NEAR(high.y() - low.y(), 1.868F, 0.01F); // a man, upright
}

TEST(Fbx, AQuadMeshWithoutSkinOpensTriangulatedInItsOrder)
{
    const auto file = dataDirectory() / "raw/dem_bones_Bone_Geom.fbx";
    if (!std::filesystem::exists(file))
        GTEST_SKIP() << "no data";
    const ImportResult result = openFbx(file);
    ASSERT_EQ(result.sequences.size(), 1U);
    const MeshSequence& sequence = result.sequences.front();
    EXPECT_EQ(sequence.name, "dem_bones_Bone_Geom");
    EXPECT_EQ(sequence.frameCount(), 1);
    EXPECT_EQ(sequence.topology->triangles().size(), 1504U);
    EXPECT_TRUE(sequence.topology->isClosed());
    const auto geometries = readFbxGeometries(readFile(file).bytes());
    ASSERT_EQ(geometries.size(), 1U);
    EXPECT_EQ(sequence.topology->vertexCount(), geometries.front().controlPoints.size() / 3);
    EXPECT_TRUE(std::any_of(result.issues.begin(), result.issues.end(),
                            [](const Issue& i) { return i.code == Issue::Code::PolygonsTriangulated; }));
}

TEST(Fbx, DamagedFilesAreRefused)
{
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { openFbx(folder / "none.fbx"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { openFbx(folder.write("empty.fbx", "")); }), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOf([&] { openFbx(folder.write("text.fbx", "This is no scene.")); }), ErrorCode::FileSyntax);
    if (!std::filesystem::exists(rocketbox()))
        GTEST_SKIP() << "no data";
    const FileContent whole = readFile(rocketbox());
    for (const std::size_t length : {std::size_t{40}, whole.size / 3, whole.size / 2}) {
        const auto cut = folder.write("cut.fbx", std::string(whole.text().substr(0, length)));
        EXPECT_EQ(codeOf([&] { openFbx(cut); }), ErrorCode::FileSyntax) << length;
    }
}

TEST(Fbx, DamagedPartsAreNotLeftOutInSilence)
{
    const TemporaryFolder folder;
    const auto fbxText = [](const RawMesh& mesh) {
        const auto& formats = rawFormats();
        const auto isText = [](const RawFormat& f) { return std::string_view(f.name) == "FbxText"; };
        return std::find_if(formats.begin(), formats.end(), isText)->bytes(mesh);
    };
    RawMesh damaged = rawPyramid();
    damaged.faces[0][1] = 77;
    const std::string text = fbxText(damaged);
    EXPECT_EQ(codeOf([&] { openFbx(folder.write("only.fbx", text)); }), ErrorCode::FileSyntax);

    const std::string good = fbxText(rawPyramid());
    const auto part = [](const std::string& file, const std::string& from, const std::string& to) {
        const auto at = file.find(from);
        return file.substr(at, file.find(to) - at);
    };
    std::string other = part(text, "\tGeometry: 100", "}\nConnections") + "}\n";
    for (const auto& [id, newId] : {std::pair{"100,", "300,"}, std::pair{"200,", "400,"}})
        other.replace(other.find(id), 4, newId);
    std::string both = good;
    both.insert(both.find("}\nConnections"), other.substr(0, other.size() - 2));
    both.insert(both.find("\tC: "), "\tC: \"OO\",400,0\n\tC: \"OO\",300,400\n");
    const ImportResult result = openFbx(folder.write("both.fbx", both));
    EXPECT_EQ(result.sequences.at(0).topology->triangles().size(), 8U);
    EXPECT_TRUE(std::any_of(result.issues.begin(), result.issues.end(), [](const Issue& issue) {
        return issue.toString().find("left out") != std::string::npos;
    }));
}

TEST(Fbx, GeometriesOfDamagedFilesAreLeftOut)
{
    EXPECT_TRUE(readFbxGeometries({}).empty());
    if (!std::filesystem::exists(rocketbox()))
        GTEST_SKIP() << "no data";
    const FileContent whole = readFile(rocketbox());
    for (std::size_t length = 0; length < whole.size; length += whole.size / 97 + 1)
        EXPECT_LE(readFbxGeometries(whole.bytes().first(length)).size(), 1U);
}
