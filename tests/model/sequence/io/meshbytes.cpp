// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/sequence/io/meshbytes.h"

#include "model/core/file.h"
#include "model/core/hdf5.h"
#include "model/sequence/io/files/appendbytes.h"
#include "tests/model/core/temporaryfolder.h"
#include "tests/model/sequence/io/glbbuilder.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <sstream>

namespace quadrille {

namespace {

void appendPoint(std::string& bytes, const Vec3f& point)
{
    for (const float x : {point.x(), point.y(), point.z()})
        appendBytes(bytes, x);
}

/// Values with something between them; a point is three values.
std::string joined(const std::vector<Vec3f>& points, const char* between = " ")
{
    std::ostringstream text;
    for (const Vec3f& p : points)
        text << (&p == points.data() ? "" : between) << p.x() << between << p.y() << between << p.z();
    return text.str();
}

/// One line for each face: before, the number of corners when asked for, and the corners.
std::string faceLines(const RawMesh& mesh, const std::string& before, bool withCount, int firstIndex)
{
    std::ostringstream text;
    for (const auto& face : mesh.faces) {
        text << before;
        if (withCount)
            text << face.size();
        for (const int corner : face)
            text << ' ' << corner + firstIndex;
        text << '\n';
    }
    return text.str();
}

std::string pointLines(const RawMesh& mesh, const std::string& before)
{
    std::string text;
    for (const Vec3f& p : mesh.points)
        text += before + joined({p}) + "\n";
    return text;
}

std::string obj(const RawMesh& mesh)
{
    return pointLines(mesh, "v ") + faceLines(mesh, "f", false, 1);
}

std::string plyHeader(const RawMesh& mesh, const std::string& encoding)
{
    return "ply\nformat " + encoding + " 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string plyText(const RawMesh& mesh)
{
    return plyHeader(mesh, "ascii") + pointLines(mesh, "") + faceLines(mesh, "", true, 0);
}

std::string plyBinary(const RawMesh& mesh)
{
    std::string bytes = plyHeader(mesh, "binary_little_endian");
    for (const Vec3f& p : mesh.points)
        appendPoint(bytes, p);
    for (const auto& face : mesh.faces) {
        appendBytes(bytes, static_cast<std::uint8_t>(face.size()));
        for (const int corner : face)
            appendBytes(bytes, std::int32_t{corner});
    }
    return bytes;
}

std::string off(const RawMesh& mesh)
{
    return "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.faces.size()) + " 0\n" +
           pointLines(mesh, "") + faceLines(mesh, "", true, 0);
}

std::string stlText(const RawMesh& mesh)
{
    std::string text = "solid test\n";
    for (const auto& face : mesh.faces) {
        text += "facet normal 0 0 1\nouter loop\n";
        for (const int corner : face)
            text += "vertex " + joined({mesh.points.at(static_cast<std::size_t>(corner))}) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid test\n";
}

std::string stlBinary(const RawMesh& mesh)
{
    std::string bytes(80, ' ');
    appendBytes(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const auto& face : mesh.faces) {
        appendPoint(bytes, Vec3f(0, 0, 1));
        for (const int corner : face)
            appendPoint(bytes, mesh.points.at(static_cast<std::size_t>(corner)));
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string anime(const RawMesh& mesh)
{
    std::string bytes;
    appendBytes(bytes, std::int32_t{3}); // frames
    appendBytes(bytes, static_cast<std::int32_t>(mesh.points.size()));
    appendBytes(bytes, static_cast<std::int32_t>(mesh.faces.size()));
    for (const Vec3f& p : mesh.points)
        appendPoint(bytes, p);
    for (const auto& face : mesh.faces) {
        for (const int corner : face)
            appendBytes(bytes, std::int32_t{corner});
    }
    bytes.append(mesh.points.size() * 2 * sizeof(Vec3f), '\0');
    return bytes;
}

GlbBuilder gltfMesh(const RawMesh& mesh)
{
    GlbBuilder builder;
    std::vector<std::uint32_t> corners;
    for (const auto& face : mesh.faces)
        corners.insert(corners.end(), face.begin(), face.end());
    builder.json["scenes"] = {{{"nodes", {0}}}};
    builder.json["nodes"] = {{{"mesh", 0}}};
    const int positions = builder.vectors(mesh.points);
    const int indices = builder.integers(corners, "SCALAR", 4);
    builder.json["meshes"] = {
        {{"primitives", {{{"attributes", {{"POSITION", positions}}}, {"indices", indices}}}}}};
    return builder;
}

std::string glb(const RawMesh& mesh)
{
    return gltfMesh(mesh).glb();
}

std::string dae(const RawMesh& mesh)
{
    std::string counts;
    std::string corners;
    for (const auto& face : mesh.faces) {
        counts += std::to_string(face.size()) + " ";
        for (const int corner : face)
            corners += std::to_string(corner) + " ";
    }
    return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
  <library_geometries><geometry id="g" name="g"><mesh>
    <source id="p"><float_array id="pa" count=")" +
           std::to_string(mesh.points.size() * 3) + "\">" + joined(mesh.points) +
           R"(</float_array><technique_common><accessor source="#pa" count=")" +
           std::to_string(mesh.points.size()) + R"(" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <polylist count=")" +
           std::to_string(mesh.faces.size()) +
           R"("><input semantic="VERTEX" source="#v" offset="0"/><vcount>)" + counts + "</vcount><p>" +
           corners + R"(</p></polylist>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node id="n"><instance_geometry url="#g"/></node>
  </visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

std::string fbxText(const RawMesh& mesh)
{
    std::string corners;
    std::size_t count = 0;
    for (const auto& face : mesh.faces) {
        for (std::size_t c = 0; c < face.size(); ++c, ++count) {
            const int index = c + 1 < face.size() ? face[c] : -1 - face[c];
            corners += (count == 0 ? "" : ",") + std::to_string(index);
        }
    }
    return R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7400
}
GlobalSettings:  {
	Version: 1000
	Properties70:  {
		P: "UpAxis", "int", "Integer", "",1
		P: "UnitScaleFactor", "double", "Number", "",100
	}
}
Objects:  {
	Geometry: 100, "Geometry::g", "Mesh" {
		Vertices: *)" +
           std::to_string(mesh.points.size() * 3) + " {\n\t\t\ta: " + joined(mesh.points, ",") +
           "\n\t\t}\n\t\tPolygonVertexIndex: *" + std::to_string(count) + " {\n\t\t\ta: " + corners +
           R"(
		}
		GeometryVersion: 124
	}
	Model: 200, "Model::g", "Mesh" {
		Version: 232
	}
}
Connections:  {
	C: "OO",200,0
	C: "OO",100,200
}
)";
}

/// Properties of a node of a binary FBX file.
struct FbxProperties
{
    std::string bytes;
    std::uint32_t count = 0;

    FbxProperties& number(char type, auto value)
    {
        bytes += type;
        appendBytes(bytes, value);
        ++count;
        return *this;
    }
    FbxProperties& text(const std::string& value)
    {
        number('S', static_cast<std::uint32_t>(value.size()));
        bytes += value;
        return *this;
    }
    template <typename Value>
    FbxProperties& array(char type, const std::vector<Value>& values)
    {
        number(type, static_cast<std::uint32_t>(values.size()));
        appendBytes(bytes, std::uint32_t{0}); // not packed
        appendBytes(bytes, static_cast<std::uint32_t>(values.size() * sizeof(Value)));
        for (const Value value : values)
            appendBytes(bytes, value);
        return *this;
    }
};

void fbxNode(std::string& out, const std::string& name, const FbxProperties& properties,
             const std::function<void()>& children = {})
{
    const std::size_t start = out.size();
    appendBytes(out, std::uint32_t{0});
    appendBytes(out, properties.count);
    appendBytes(out, static_cast<std::uint32_t>(properties.bytes.size()));
    appendBytes(out, static_cast<std::uint8_t>(name.size()));
    out += name + properties.bytes;
    if (children) {
        children();
        out.append(13, '\0');
    }
    const auto end = static_cast<std::uint32_t>(out.size());
    std::memcpy(out.data() + start, &end, sizeof(end));
}

std::string fbxBinary(const RawMesh& mesh)
{
    std::vector<double> points;
    for (const Vec3f& p : mesh.points) {
        for (const float x : {p.x(), p.y(), p.z()})
            points.push_back(static_cast<double>(x));
    }
    std::vector<std::int32_t> corners;
    for (const auto& face : mesh.faces) {
        corners.insert(corners.end(), face.begin(), face.end());
        corners.back() = -1 - corners.back();
    }
    std::string out("Kaydara FBX Binary  \0\x1a\0", 23);
    appendBytes(out, std::uint32_t{7400});
    const auto number = [](std::int32_t value) { return FbxProperties().number('I', value); };
    const auto link = [&](std::int64_t from, std::int64_t to) {
        fbxNode(out, "C", FbxProperties().text("OO").number('L', from).number('L', to));
    };
    fbxNode(out, "FBXHeaderExtension", {}, [&] {
        fbxNode(out, "FBXHeaderVersion", number(1003));
        fbxNode(out, "FBXVersion", number(7400));
    });
    fbxNode(out, "GlobalSettings", {}, [&] { fbxNode(out, "Version", number(1000)); });
    const auto object = [](std::int64_t id, const std::string& kind) {
        return FbxProperties().number('L', id).text("g" + std::string("\0\1", 2) + kind).text("Mesh");
    };
    fbxNode(out, "Objects", {}, [&] {
        fbxNode(out, "Geometry", object(100, "Geometry"), [&] {
            fbxNode(out, "Vertices", FbxProperties().array('d', points));
            fbxNode(out, "PolygonVertexIndex", FbxProperties().array('i', corners));
        });
        fbxNode(out, "Model", object(200, "Model"), [&] { fbxNode(out, "Version", number(232)); });
    });
    fbxNode(out, "Connections", {}, [&] {
        link(200, 0);
        link(100, 200);
    });
    out.append(13, '\0');
    return out;
}

void writeDataset(const Hdf5Handle& file, const char* name, std::vector<hsize_t> extents, hid_t type,
                  const void* values)
{
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                           H5Sclose);
    const Hdf5Handle dataset(
        H5Dcreate2(file.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
    H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
}

std::string hdf5(const RawMesh& mesh)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "mesh.h5";
    const auto lock = lockHdf5();
    {
        const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
        std::vector<std::int32_t> corners;
        for (const auto& face : mesh.faces)
            corners.insert(corners.end(), face.begin(), face.end());
        writeDataset(file, "faces", {mesh.faces.size(), 3}, H5T_NATIVE_INT32, corners.data());
        std::vector<Vec3f> frames = mesh.points;
        frames.insert(frames.end(), mesh.points.begin(), mesh.points.end());
        writeDataset(file, "take", {2, mesh.points.size(), 3}, H5T_NATIVE_FLOAT, frames.data());
    }
    return std::string(readFile(path).text());
}

} // namespace

const std::vector<RawFormat>& rawFormats()
{
    static const std::vector<RawFormat> formats{
        {.name = "Obj", .extension = ".obj", .bytes = obj, .isText = true, .hasPolygons = true},
        {.name = "PlyText", .extension = ".ply", .bytes = plyText, .isText = true, .hasPolygons = true},
        {.name = "PlyBinary", .extension = ".ply", .bytes = plyBinary, .hasPolygons = true},
        {.name = "Off", .extension = ".off", .bytes = off, .isText = true, .hasPolygons = true},
        {.name = "StlText", .extension = ".stl", .bytes = stlText, .isText = true, .hasIndices = false},
        {.name = "StlBinary", .extension = ".stl", .bytes = stlBinary, .hasIndices = false},
        {.name = "Anime", .extension = ".anime", .bytes = anime},
        {.name = "Glb", .extension = ".glb", .bytes = glb},
        {.name = "Collada", .extension = ".dae", .bytes = dae, .isText = true, .hasPolygons = true},
        {.name = "FbxText",
         .extension = ".fbx",
         .bytes = fbxText,
         .isText = true,
         .hasPolygons = true,
         .keepsIndices = false},
        {.name = "FbxBinary", .extension = ".fbx", .bytes = fbxBinary, .hasPolygons = true},
        {.name = "Hdf5", .extension = ".h5", .bytes = hdf5},
    };
    return formats;
}

RawMesh rawPyramid()
{
    RawMesh mesh;
    mesh.points = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    for (int i = 0; i < 4; ++i) {
        const int a = 1 + i;
        const int b = 1 + (i + 1) % 4;
        mesh.faces.push_back({0, a, b});
        mesh.faces.push_back({5, b, a});
    }
    return mesh;
}

} // namespace quadrille
