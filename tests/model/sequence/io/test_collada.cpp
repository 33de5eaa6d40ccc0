// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/scene/assimpscene.h"
#include "tests/model/sequence/io/sceneiotest.h"

#include <gmock/gmock.h>

using namespace quadrille;

namespace {

/// A quad, cut along its diagonal by its texture coordinates, in centimetres and z up. Its node rises along
/// the file's z by 300 units within a second.
const std::string risingQuad = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="quad" name="quad"><mesh>
    <source id="p"><float_array id="pa" count="12">0 0 0 100 0 0 100 0 100 0 0 100</float_array>
      <technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <source id="t"><float_array id="ta" count="8">0 0 1 0 1 1 0.5 0.5</float_array>
      <technique_common><accessor source="#ta" count="4" stride="2"><param name="S" type="float"/>
      <param name="T" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/>
      <input semantic="TEXCOORD" source="#t" offset="1" set="0"/>
      <p>0 0 1 1 2 2 0 3 2 3 3 3</p></triangles>
  </mesh></geometry></library_geometries>
  <library_animations><animation id="rise">
    <source id="in"><float_array id="ina" count="2">0 1</float_array><technique_common>
      <accessor source="#ina" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
    <source id="out"><float_array id="outa" count="2">0 300</float_array><technique_common>
      <accessor source="#outa" count="2" stride="1"><param name="Z" type="float"/></accessor></technique_common></source>
    <source id="how"><Name_array id="howa" count="2">LINEAR LINEAR</Name_array><technique_common>
      <accessor source="#howa" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor></technique_common></source>
    <sampler id="s"><input semantic="INPUT" source="#in"/><input semantic="OUTPUT" source="#out"/>
      <input semantic="INTERPOLATION" source="#how"/></sampler>
    <channel source="#s" target="lift/where.Z"/>
  </animation></library_animations>
  <library_visual_scenes><visual_scene id="scene">
    <node id="lift" name="lift"><translate sid="where">0 0 0</translate><instance_geometry url="#quad"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";

ImportResult openCollada(const std::filesystem::path& path)
{
    ImportOptions options;
    options.fps = 10;
    return ColladaImporter().open(fileSource(path), options, {});
}

} // namespace

TEST(Collada, AMovingNodeIsBakedInMetresAndYUp)
{
    const TemporaryFolder folder;
    const ImportResult result = openCollada(folder.write("lift.dae", risingQuad));
    ASSERT_EQ(result.sequences.size(), 1U);
    const MeshSequence& sequence = result.sequences.front();
    EXPECT_EQ(sequence.topology->vertexCount(), 4U);
    EXPECT_EQ(sequence.topology->triangles().size(), 2U);
    ASSERT_EQ(sequence.frameCount(), 11);
    ASSERT_TRUE(result.coordinates);
    EXPECT_EQ(*result.coordinates, CoordinateSystem());
    for (const int f : {0, 5, 10}) {
        const Frame frame = sequence.frame(FrameIndex(f));
        const float lift = 0.3F * static_cast<float>(f);
        EXPECT_LT((frame.positions()[0] - Vec3f(0, lift, 0)).norm(), 1e-5F) << f;
        EXPECT_LT((frame.positions()[2] - Vec3f(1, 1 + lift, 0)).norm(), 1e-5F) << f;
    }
}

TEST(Collada, BadFilesAreRefused)
{
    const TemporaryFolder folder;
    EXPECT_EQ(codeOf([&] { openCollada(folder / "none.dae"); }), ErrorCode::FileNotFound);
    EXPECT_EQ(codeOf([&] { openCollada(folder.write("empty.dae", "")); }), ErrorCode::FileEmpty);
    EXPECT_EQ(codeOf([&] { openCollada(folder.write("text.dae", "hello")); }), ErrorCode::FileSyntax);
    EXPECT_EQ(codeOf([&] { openCollada(folder.write("cut.dae", risingQuad.substr(0, 900))); }),
              ErrorCode::FileSyntax);
}

TEST(Collada, ASceneWithoutAMeshSaysSo)
{
    const TemporaryFolder folder;
    std::string text = risingQuad;
    const std::string instance = "<instance_geometry url=\"#quad\"/>";
    text.erase(text.find(instance), instance.size());
    EXPECT_EQ(codeOf([&] { openCollada(folder.write("bones.dae", text)); }), ErrorCode::SceneWithoutMesh);
}
