// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// sample_body FOLDER: makes the bodies of the built-in sample and writes them into FOLDER.
#include "model/core/file.h"
#include "model/sample/figures.h"
#include "resources/sample/maker/atlas.h"
#include "resources/sample/maker/character.h"
#include "resources/sample/maker/rig.h"
#include "resources/sample/maker/texturebake.h"

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int textureSize = 1024;

SampleFigure makeFigure(const std::string& name, const Body& body, double spacing, double edgeScale,
                        const Palette& palette)
{
    const SurfaceMesh half = extractHalfSurface(body, spacing);
    const SurfaceMesh mesh = mirrorHalf(remeshHalf(half, body, edgeLengthFor(body, edgeScale)));
    const Atlas atlas = makeAtlas(mesh, body);
    SampleFigure figure;
    figure.name = name;
    figure.points = mesh.points;
    figure.faces.vertexCount = static_cast<std::uint32_t>(mesh.points.size());
    figure.faces.triangles = mesh.triangles;
    figure.faces.uvs = atlas.uvs;
    figure.faces.triangleUvs = atlas.triangleUvs;
    const TexelMap texels = mapTexels(figure.faces, textureSize, textureSize / 128);
    figure.texture = bakeTexture(mesh, body, texels, palette);
    return figure;
}

SampleFigures makeFigures()
{
    SampleFigures figures;
    const Body body;
    const Body target(targetProportions());
    figures.character = makeFigure("Quad", body, 0.005, 1.18, {});
    figures.target = makeFigure("Otto", target, 0.0055, 0.98, targetPalette());
    const SurfaceMesh mesh{figures.character.points, figures.character.faces.triangles};
    figures.skeleton = makeSkeleton(body);
    figures.weights = boneHeatWeights(mesh, figures.skeleton);
    figures.landmarks =
        makeLandmarks(body, mesh, target, {figures.target.points, figures.target.faces.triangles});
    return figures;
}

/// Values as they lie in memory.
template <typename Value>
Json toBytes(const std::vector<Value>& values)
{
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    return Json::binary(Json::binary_t::container_type(bytes, bytes + values.size() * sizeof(Value)));
}

Json toJson(const SampleFigure& figure)
{
    return {{"name", figure.name},
            {"points", toBytes(figure.points)},
            {"triangles", toBytes(figure.faces.triangles)},
            {"uvs", toBytes(figure.faces.uvs)},
            {"triangle_uvs", toBytes(figure.faces.triangleUvs)}};
}

Json toJson(const SurfacePoint& point)
{
    return {{"triangle", point.triangle.value},
            {"weights", {point.weights.x(), point.weights.y(), point.weights.z()}}};
}

void writeFigures(const SampleFigures& figures, const fs::path& folder)
{
    Json landmarks = Json::array();
    for (const LandmarkPair& pair : figures.landmarks)
        landmarks.push_back(
            {{"name", pair.name}, {"source", toJson(pair.source)}, {"target", toJson(pair.target)}});
    const Json json = {{"character", toJson(figures.character)},
                       {"target", toJson(figures.target)},
                       {"skeleton",
                        {{"names", figures.skeleton.names},
                         {"parents", figures.skeleton.parents},
                         {"rest", toBytes(figures.skeleton.rest)}}},
                       {"weights", toBytes(figures.weights)},
                       {"landmarks", landmarks}};
    const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
    writeAtomically(folder / "figures.cbor",
                    std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    for (const SampleFigure* figure : {&figures.character, &figures.target})
        writeImage(figure->texture, folder / (figure->name + ".png"));
}

} // namespace

} // namespace quadrille

int main(int count, char** arguments)
{
    if (count != 2) {
        std::fputs("Usage: sample_body FOLDER\n", stderr);
        return 2;
    }
    try {
        quadrille::writeFigures(quadrille::makeFigures(), arguments[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "sample_body: %s\n", error.what());
        return 1;
    }
    return 0;
}
