// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/gltf/gltf.h"
#include "tests/model/markedpng.h"
#include "tests/model/sequence/io/glbbuilder.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <cmath>
#include <gmock/gmock.h>
#include <map>

using namespace quadrille;

namespace {

ImportResult openGltf(const std::filesystem::path& path, double fps = 30, const std::string& clip = {})
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
    const ImportResult result = openGltf(file);
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

namespace {

ErrorCode codeOfScene(const TemporaryFolder& folder, const std::string& content)
{
    return codeOf([&] { openGltf(folder.write("bad.glb", content)); });
}

} // namespace

TEST(Gltf, ASkinIsBakedFromFirstToLastKey)
{
    const TemporaryFolder folder;
    const ImportResult result = openGltf(folder.write("quad.glb", skinnedQuad().glb()), 4);
    ASSERT_EQ(result.sequences.size(), 1U);
    const MeshSequence& sequence = result.sequences.front();
    EXPECT_EQ(sequence.name, "Slide");
    EXPECT_EQ(sequence.fps, 4);
    ASSERT_EQ(sequence.frameCount(), 5);
    ASSERT_EQ(sequence.topology->vertexCount(), 4U);
    EXPECT_EQ(sequence.topology->data().uvs.size(), 6U);
    EXPECT_EQ(sequence.topology->data().uvs[0], Vec2f(0, 0)); // glTF counts v from the top
    const Frame frame = sequence.frame(FrameIndex(2));
    EXPECT_LT((frame.positions()[1] - Vec3f(1.5F, 0, 0)).norm(), 1e-6F);
    EXPECT_LT((frame.positions()[3] - Vec3f(0, 1, 0)).norm(), 1e-6F);
    EXPECT_TRUE(std::any_of(result.issues.begin(), result.issues.end(), [](const Issue& i) {
        return i.code == Issue::Code::VerticesWelded && i.toString().find("6 vertices") != std::string::npos;
    }));
    ASSERT_TRUE(result.coordinates);
    EXPECT_EQ(*result.coordinates, CoordinateSystem());
}

TEST(Gltf, TextWithADataUriOrAFileReadsTheSame)
{
    const TemporaryFolder folder;
    const GlbBuilder quad = skinnedQuad();
    folder.write("my buffer.bin", quad.buffer);
    const auto frames = loadFrames(openGltf(folder.write("a.glb", quad.glb())).sequences.at(0));
    const auto file = folder.write("b.gltf", quad.gltf("my%20buffer.bin"));
    EXPECT_EQ(loadFrames(openGltf(file).sequences.at(0)), frames);
    std::string base64;
    const std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < quad.buffer.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 |
                   (i + k < quad.buffer.size() ? static_cast<unsigned char>(quad.buffer[i + k]) : 0U);
        for (int shift = 18; shift >= 0; shift -= 6)
            base64 += letters[bits >> shift & 63];
    }
    const auto data = folder.write("c.gltf", quad.gltf("data:application/octet-stream;base64," + base64));
    EXPECT_EQ(loadFrames(openGltf(data).sequences.at(0)), frames);
}

TEST(Gltf, NodeMotionIsBakedRigidlyAndMeshesAreMerged)
{
    const TemporaryFolder folder;
    GlbBuilder quad = skinnedQuad();
    quad.json.erase("skins");
    quad.json["nodes"] = {{{"mesh", 0}, {"scale", {2, 2, 2}}}, {{"mesh", 0}}, {{"children", {1}}}};
    quad.json["scenes"] = {{{"nodes", {0, 2}}}};
    const MeshSequence sequence = openGltf(folder.write("two.glb", quad.glb()), 1).sequences.at(0);
    ASSERT_EQ(sequence.topology->vertexCount(), 8U);
    ASSERT_EQ(sequence.frameCount(), 2);
    EXPECT_LT((sequence.frame(FrameIndex(1)).positions()[1] - Vec3f(2, 0, 0)).norm(), 1e-6F);
    EXPECT_LT((sequence.frame(FrameIndex(1)).positions()[5] - Vec3f(2, 0, 0)).norm(), 1e-6F);
    EXPECT_LT((sequence.frame(FrameIndex(0)).positions()[5] - Vec3f(1, 0, 0)).norm(), 1e-6F);
}

TEST(Gltf, MorphTargetsFollowTheirWeights)
{
    const TemporaryFolder folder;
    GlbBuilder quad = skinnedQuad();
    quad.json.erase("skins");
    quad.json["nodes"] = {{{"mesh", 0}}};
    quad.json["scenes"] = {{{"nodes", {0}}}};
    const std::vector<Vec3f> up(6, Vec3f(0, 0, 1));
    quad.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", quad.vectors(up)}}};
    quad.json["meshes"][0]["weights"] = {0.25};
    const int times = quad.floats({0, 1}, "SCALAR");
    const int weights = quad.floats({0, 1}, "SCALAR");
    quad.json["animations"] = {
        {{"name", "Up"},
         {"samplers", {{{"input", times}, {"output", weights}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    const MeshSequence moving = openGltf(folder.write("morph.glb", quad.glb()), 2).sequences.at(0);
    ASSERT_EQ(moving.frameCount(), 3);
    EXPECT_NEAR(moving.frame(FrameIndex(1)).positions()[0].z(), 0.5, 1e-6);
    quad.json.erase("animations");
    const MeshSequence still = openGltf(folder.write("still.glb", quad.glb())).sequences.at(0);
    EXPECT_EQ(still.name, "still");
    EXPECT_NEAR(still.frame(FrameIndex(0)).positions()[0].z(), 0.25, 1e-6);
}

TEST(Gltf, StepAndCubicKeysAreUnderstood)
{
    const TemporaryFolder folder;
    GlbBuilder quad = skinnedQuad();
    quad.json["animations"][0]["samplers"][0]["interpolation"] = "STEP";
    auto x = [&](double frame) {
        const ImportResult result = openGltf(folder.write("k.glb", quad.glb()), 4);
        return result.sequences.at(0).frame(FrameIndex(static_cast<int>(frame))).positions()[1].x();
    };
    EXPECT_NEAR(x(3), 1, 1e-6);
    EXPECT_NEAR(x(4), 2, 1e-6);
    const std::vector<Vec3f> cubic = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    quad.json["animations"][0]["samplers"][0]["output"] = quad.vectors(cubic);
    quad.json["animations"][0]["samplers"][0]["interpolation"] = "CUBICSPLINE";
    EXPECT_NEAR(x(1), 1 + 0.15625, 1e-6); // 3t² − 2t³ at a quarter
}

TEST(Gltf, PicturesInsideAndBesideTheFileAreFound)
{
    const TemporaryFolder folder;
    Image red(2, 2);
    std::fill(red.pixels.begin(), red.pixels.end(), std::uint8_t{255});
    GlbBuilder quad = skinnedQuad();
    quad.json["meshes"][0]["primitives"][0]["material"] = 0;
    quad.json["materials"] = {
        {{"name", "skin"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
    quad.json["textures"] = {{{"source", 0}}};
    red.pixel(0, 1)[0] = 100;
    const auto png =
        test::withPngGamma(encodeImage(red, ".png"), 100'000); // which glTF says is to be ignored
    GlbBuilder inside = quad;
    const int view = inside.bytes(std::string(reinterpret_cast<const char*>(png.data()), png.size()));
    inside.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
    const auto embedded = openGltf(folder.write("in.glb", inside.glb())).sequences.at(0);
    EXPECT_EQ(*embedded.texture(FrameIndex(0)), red);
    EXPECT_EQ(embedded.topology->data().materials, std::vector<std::string>{"skin"});

    quad.json["images"] = {{{"uri", "red.png"}}};
    const ImportResult missing = openGltf(folder.write("beside.glb", quad.glb()));
    EXPECT_EQ(missing.sequences.at(0).textures.kind(), TextureSet::Kind::None);
    EXPECT_EQ(missing.issues.at(0).code, Issue::Code::TextureMissing);
    folder.write("red.png", std::string(reinterpret_cast<const char*>(png.data()), png.size()));
    EXPECT_EQ(*openGltf(folder / "beside.glb").sequences.at(0).texture(FrameIndex(0)), red);
}

TEST(Gltf, OneClipCanBeChosen)
{
    const TemporaryFolder folder;
    GlbBuilder quad = skinnedQuad();
    quad.json["animations"].push_back(quad.json["animations"][0]);
    const auto file = folder.write("clips.glb", quad.glb());
    const ImportResult both = openGltf(file);
    ASSERT_EQ(both.sequences.size(), 2U);
    EXPECT_EQ(both.sequences[1].name, "Slide 2");
    EXPECT_EQ(openGltf(file, 30, "Slide").sequences.size(), 1U);
    EXPECT_EQ(codeOf([&] { openGltf(file, 30, "Jump"); }), ErrorCode::BadArgument);
    EXPECT_EQ(codeOf([&] { openGltf(file, 0); }), ErrorCode::BadArgument);
}

TEST(Gltf, DamagedFilesAreRefused)
{
    const TemporaryFolder folder;
    const std::string good = skinnedQuad().glb();
    EXPECT_EQ(codeOf([&] { openGltf(folder / "none.glb"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOfScene(folder, ""), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOfScene(folder, "glTF"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfScene(folder, "no magic here"), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfScene(folder, good.substr(0, 300)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOfScene(folder, good.substr(0, good.size() - 8)), ErrorCode::FileTruncated);
    EXPECT_EQ(codeOf([&] { openGltf(folder.write("lost.gltf", skinnedQuad().gltf("lost.bin"))); }),
              ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { openGltf(folder.write("bare.gltf", skinnedQuad().gltf(""))); }),
              ErrorCode::FileTruncated);
}

TEST(Gltf, WrongContentIsRefused)
{
    const TemporaryFolder folder;
    const auto codeOfChange = [&](auto&& change) {
        GlbBuilder quad = skinnedQuad();
        change(quad);
        return codeOfScene(folder, quad.glb());
    };
    auto primitive = [](GlbBuilder& b) -> nlohmann::json& { return b.json["meshes"][0]["primitives"][0]; };
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["accessors"][0]["count"] = 4000000000; }),
              ErrorCode::CountTooLarge);
    EXPECT_EQ(
        codeOfChange([&](GlbBuilder& b) {
            b.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", 4000000000}});
            primitive(b)["attributes"]["POSITION"] = b.json["accessors"].size() - 1;
        }),
        ErrorCode::CountTooLarge);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = 9999; }),
              ErrorCode::FileTruncated);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["bufferViews"][0]["byteOffset"] = -4; }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([&](GlbBuilder& b) {
                  primitive(b)["indices"] = b.integers({0, 1, 6}, "SCALAR", 4);
              }),
              ErrorCode::IndexOutOfRange);
    EXPECT_EQ(codeOfChange([&](GlbBuilder& b) { primitive(b)["attributes"].erase("POSITION"); }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["skins"][0]["joints"] = {1}; }),
              ErrorCode::IndexOutOfRange);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) {
                  b.json["skins"][0]["joints"] = {1, 77};
              }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["nodes"][1]["children"] = {1}; }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) {
                  b.json["nodes"][1]["children"] = {2};
                  b.json["nodes"][2]["children"] = {1};
              }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["nodes"][0]["scale"] = "big"; }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) { b.json["asset"]["version"] = "1.0"; }), ErrorCode::FileSyntax);
    EXPECT_EQ(
        codeOfChange([](GlbBuilder& b) { b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
        ErrorCode::FormatRefused);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) {
                  b.json["nodes"] = {{{"camera", 0}}};
                  b.json.erase("animations");
              }),
              ErrorCode::SceneWithoutMesh);
    EXPECT_EQ(codeOfChange([&](GlbBuilder& b) {
                  const float nan = std::numeric_limits<float>::quiet_NaN();
                  std::memcpy(b.buffer.data() + 4, &nan, 4);
              }),
              ErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) {
                  b.json["animations"][0]["samplers"][0]["input"] = b.floats({1, 1}, "SCALAR");
              }),
              ErrorCode::FileSyntax);
    EXPECT_EQ(codeOfChange([](GlbBuilder& b) {
                  b.json["animations"][0]["samplers"][0]["input"] = b.floats({0, 1e30F}, "SCALAR");
              }),
              ErrorCode::CountTooLarge);
}
