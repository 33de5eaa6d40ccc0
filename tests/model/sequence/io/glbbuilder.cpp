// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/sequence/io/glbbuilder.h"

#include "model/sequence/io/files/appendbytes.h"

#include <cstring>
#include <map>

namespace quadrille {

GlbBuilder::GlbBuilder()
{
    json = {{"asset", {{"version", "2.0"}}},
            {"accessors", nlohmann::json::array()},
            {"bufferViews", nlohmann::json::array()}};
}

int GlbBuilder::bytes(const std::string& data)
{
    buffer.resize((buffer.size() + 3) / 4 * 4);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", data.size()}});
    buffer += data;
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GlbBuilder::accessor(int componentType, std::size_t valueCount, const std::string& type)
{
    static const std::map<std::string, std::size_t> components = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", componentType},
                                 {"count", valueCount / components.at(type)},
                                 {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
}

int GlbBuilder::floats(const std::vector<float>& values, const std::string& type)
{
    std::string data;
    for (const float value : values)
        appendBytes(data, value);
    bytes(data);
    return accessor(5126, values.size(), type);
}

int GlbBuilder::vectors(const std::vector<Vec3f>& values)
{
    std::vector<float> flat;
    for (const Vec3f& v : values)
        flat.insert(flat.end(), {v.x(), v.y(), v.z()});
    return floats(flat, "VEC3");
}

int GlbBuilder::integers(const std::vector<std::uint32_t>& values, const std::string& type, int bytesEach)
{
    std::string data;
    for (const std::uint32_t value : values) {
        if (bytesEach == 1)
            appendBytes(data, static_cast<std::uint8_t>(value));
        else if (bytesEach == 2)
            appendBytes(data, static_cast<std::uint16_t>(value));
        else
            appendBytes(data, value);
    }
    bytes(data);
    return accessor(bytesEach == 1 ? 5121 : bytesEach == 2 ? 5123 : 5125, values.size(), type);
}

std::string GlbBuilder::gltf(const std::string& bufferUri) const
{
    nlohmann::json complete = json;
    nlohmann::json entry = {{"byteLength", buffer.size()}};
    if (!bufferUri.empty())
        entry["uri"] = bufferUri;
    complete["buffers"] = {entry};
    return complete.dump();
}

std::string GlbBuilder::glb() const
{
    std::string text = gltf("");
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4);
    std::string file = "glTF";
    appendBytes(file, std::uint32_t{2});
    appendBytes(file, static_cast<std::uint32_t>(28 + text.size() + binary.size()));
    appendBytes(file, static_cast<std::uint32_t>(text.size()));
    file += "JSON";
    file += text;
    appendBytes(file, static_cast<std::uint32_t>(binary.size()));
    file += std::string("BIN\0", 4);
    return file + binary;
}

GlbBuilder skinnedQuad()
{
    GlbBuilder b;
    const int positions = b.vectors({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    const int uvs = b.floats({0, 1, 1, 1, 1, 0, 0.5, 1, 0.5, 0.5, 0.5, 0}, "VEC2");
    const int joints =
        b.integers({0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 1);
    const int weights =
        b.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    const int indices = b.integers({0, 1, 2, 3, 4, 5}, "SCALAR", 2);
    const int times = b.floats({0.5, 1.5}, "SCALAR");
    const int moves = b.vectors({{0, 0, 0}, {1, 0, 0}});
    b.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    b.json["nodes"] = {
        {{"mesh", 0}, {"skin", 0}, {"name", "quad"}}, {{"name", "still"}}, {{"name", "slider"}}};
    b.json["skins"] = {{{"joints", {1, 2}}}};
    b.json["meshes"] = {
        {{"primitives",
          {{{"attributes",
             {{"POSITION", positions}, {"TEXCOORD_0", uvs}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
            {"indices", indices}}}}}};
    b.json["animations"] = {
        {{"name", "Slide"},
         {"samplers", {{{"input", times}, {"output", moves}, {"interpolation", "LINEAR"}}}},
         {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}}};
    return b;
}

} // namespace quadrille
