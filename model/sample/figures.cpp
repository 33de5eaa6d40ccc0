// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/figures.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

// See figures.s.
extern "C" {
extern const std::byte quadrilleFigures[];
extern const std::byte quadrilleFiguresEnd[];
extern const std::byte quadrilleQuadTexture[];
extern const std::byte quadrilleQuadTextureEnd[];
extern const std::byte quadrilleOttoTexture[];
extern const std::byte quadrilleOttoTextureEnd[];
}

namespace quadrille {

namespace {

using Json = nlohmann::ordered_json;

/// Values as they lie in memory.
template <typename Value>
std::vector<Value> arrayOf(const Json& bytes)
{
    const Json::binary_t& from = bytes.get_binary();
    std::vector<Value> values(from.size() / sizeof(Value));
    std::memcpy(static_cast<void*>(values.data()), from.data(), from.size());
    return values;
}

SampleFigure figureOf(const Json& json, std::span<const std::byte> texture)
{
    SampleFigure figure;
    json.at("name").get_to(figure.name);
    figure.points = arrayOf<Vec3d>(json.at("points"));
    figure.faces.vertexCount = static_cast<std::uint32_t>(figure.points.size());
    figure.faces.triangles = arrayOf<Triangle>(json.at("triangles"));
    figure.faces.uvs = arrayOf<Vec2f>(json.at("uvs"));
    figure.faces.triangleUvs = arrayOf<std::array<std::uint32_t, 3>>(json.at("triangle_uvs"));
    figure.texture = decodeImage(texture);
    return figure;
}

SurfacePoint pointOf(const Json& json)
{
    const Json& weights = json.at("weights");
    return {TriangleIndex(json.at("triangle").get<std::uint32_t>()),
            Vec3d(weights.at(0), weights.at(1), weights.at(2))};
}

} // namespace

SampleFigures shippedFigures()
{
    const Json json = Json::from_cbor(std::span(quadrilleFigures, quadrilleFiguresEnd));
    SampleFigures figures;
    figures.character =
        figureOf(json.at("character"), std::span(quadrilleQuadTexture, quadrilleQuadTextureEnd));
    figures.target = figureOf(json.at("target"), std::span(quadrilleOttoTexture, quadrilleOttoTextureEnd));
    const Json& skeleton = json.at("skeleton");
    skeleton.at("names").get_to(figures.skeleton.names);
    skeleton.at("parents").get_to(figures.skeleton.parents);
    figures.skeleton.rest = arrayOf<Vec3d>(skeleton.at("rest"));
    figures.weights = arrayOf<VertexWeights>(json.at("weights"));
    for (const Json& mark : json.at("landmarks"))
        figures.landmarks.push_back(
            {mark.at("name"), pointOf(mark.at("source")), pointOf(mark.at("target"))});
    return figures;
}

} // namespace quadrille
