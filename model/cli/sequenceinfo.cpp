// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/cli/sequenceinfo.h"

#include "model/core/bounds.h"
#include "model/project/document/lengthunit.h"
#include "model/project/json/jsontext.h"
#include "model/sequence/io/ratebeside.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace quadrille::cli {

namespace {

const char* kindName(TextureSet::Kind kind)
{
    switch (kind) {
    case TextureSet::Kind::None:
        return "none";
    case TextureSet::Kind::Single:
        return "single";
    case TextureSet::Kind::PerFrame:
        return "per_frame";
    case TextureSet::Kind::PerMaterial:
        return "per_material";
    }
    return "";
}

Json textureJson(const TextureSet& textures)
{
    Json json = Json::object();
    json["kind"] = kindName(textures.kind());
    json["count"] = textures.textures().size();
    json["files"] = Json::array();
    for (const Texture& texture : textures.textures()) {
        if (!texture.file.empty())
            json["files"].push_back(texture.file.generic_string());
    }
    return json;
}

/// A float as a double of the same shortest decimal text, so that 0.1 is written as 0.1.
double plain(float value)
{
    std::array<char, 32> text{};
    const auto* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    double number = 0;
    std::from_chars(text.data(), end, number);
    return number;
}

Json pointJson(const Vec3f& point)
{
    return Json::array({plain(point.x()), plain(point.y()), plain(point.z())});
}

/// Reads every frame, and keeps none.
Bounds sequenceBounds(const MeshSequence& sequence, const Progress& progress)
{
    MediaCache none(0);
    const auto boundsAt = [&](std::int64_t f) {
        return boundsOf(sequence.frame(FrameIndex(f), none).positions());
    };
    const std::int64_t count = sequence.frameCount();
    std::atomic<std::int64_t> done = 0;
    try {
        return tbb::parallel_reduce(
            tbb::blocked_range<std::int64_t>(0, count), Bounds(),
            [&](const tbb::blocked_range<std::int64_t>& frames, Bounds bounds) {
                for (std::int64_t f = frames.begin(); f < frames.end(); ++f) {
                    progress.report(done++, count);
                    bounds.add(boundsAt(f));
                }
                return bounds;
            },
            [](Bounds a, const Bounds& b) {
                a.add(b);
                return a;
            });
    } catch (const Error&) {
        // Which frame is met first depends on the threads: tell of the first that is bad.
        for (std::int64_t f = 0; f < count; ++f) {
            progress.report(f, count);
            boundsAt(f);
        }
        throw;
    }
}

Json boundsJson(const MeshSequence& sequence, const Progress& progress)
{
    const Bounds bounds = sequenceBounds(sequence, progress);
    Json json = Json::object();
    json["min"] = pointJson(bounds.min.cast<float>());
    json["max"] = pointJson(bounds.max.cast<float>());
    return json;
}

std::int64_t zeroAreaTriangles(const MeshSequence& sequence)
{
    const Frame frame = sequence.frame(FrameIndex(0));
    const Positions positions = frame.positions();
    std::int64_t count = 0;
    for (const Triangle& triangle : sequence.topology->triangles()) {
        const auto corner = [&](std::size_t i) -> Vec3d {
            return positions[triangle.at(i).value].cast<double>();
        };
        const Vec3d a = corner(1) - corner(0);
        const Vec3d b = corner(2) - corner(0);
        count += a.cross(b).norm() == 0 ? 1 : 0;
    }
    return count;
}

std::string valueText(const Json& value)
{
    if (value.is_string())
        return value.get<std::string>();
    std::string text = writeJson(value);
    text.pop_back();
    return text;
}

std::string fixed(double value, int digits)
{
    std::array<char, 64> text{};
    const auto* end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
    return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

std::string counted(std::int64_t count, const char* one, const char* many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string textureText(const Json& textures)
{
    const auto count = textures["count"].get<std::int64_t>();
    const std::string kind = textures["kind"];
    if (kind == "none")
        return "no texture";
    if (kind == "per_frame")
        return counted(count, "texture", "textures") + ", one per frame";
    if (kind == "per_material")
        return counted(count, "texture", "textures") + ", by material";
    return "one texture";
}

/// Extents along the axes with three significant places of the largest, in the file's own unit.
std::string boundsText(const Json& info)
{
    const Json& low = info["bounds"]["min"];
    const Json& high = info["bounds"]["max"];
    double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        largest = std::max(largest, high[axis].get<double>() - low[axis].get<double>());
    const int digits =
        largest > 0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 9) : 3;
    std::string out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out += axis == 0 ? "" : ", ";
        out += "xyz"[axis];
        out += ' ';
        out += fixed(low[axis].get<double>(), digits) + " … " + fixed(high[axis].get<double>(), digits);
    }
    const auto unit = unitName(info["metres_per_unit"].get<double>());
    if (unit)
        out.append(" ").append(*unit);
    return out.append(", ").append(info["up_axis"].get<std::string>()).append(" up");
}

/// The rate, and what says it: the file itself, or one beside it; null where nothing does.
void addRate(Json& info, const std::string& path, const MeshSequence& sequence, bool hasOwnFps)
{
    const bool moves = sequence.frameCount() > 1;
    const auto beside = hasOwnFps || !moves ? std::nullopt : rateBeside(path, sequence.frameCount());
    info["fps"] = nullptr;
    info["fps_source"] = nullptr;
    if (hasOwnFps) {
        info["fps"] = sequence.fps;
        info["fps_source"] = path;
    } else if (beside) {
        info["fps"] = beside->fps;
        info["fps_source"] = beside->file.string();
    }
    const bool isKnown = !info["fps"].is_null();
    info["duration"] = isKnown ? Json(static_cast<double>(sequence.frameCount()) / info["fps"].get<double>())
                               : Json(nullptr);
}

std::string rateText(const Json& info)
{
    if (info["fps"].is_null())
        return info["frames"].get<std::int64_t>() > 1 ? ", rate unknown" : "";
    std::string text = " at " + valueText(info["fps"]) + " fps";
    if (info["fps_source"] != info["path"])
        text += " (from " + std::filesystem::path(info["fps_source"].get<std::string>()).filename().string() +
                ")";
    return text + ", " + fixed(info["duration"].get<double>(), 2) + " s";
}

} // namespace

Json sequenceInfo(const std::string& path, const MeshSequence& sequence, const ImportResult& imported,
                  const Progress& progress)
{
    const TopologyStatistics& statistics = sequence.topology->statistics();
    const auto coordinates = imported.coordinates.value_or(CoordinateSystem{});
    Json info = Json::object();
    info["path"] = path;
    info["name"] = sequence.name;
    info["vertices"] = sequence.topology->vertexCount();
    info["triangles"] = sequence.topology->triangles().size();
    info["frames"] = sequence.frameCount();
    addRate(info, path, sequence, imported.hasOwnFps);
    info["components"] = statistics.components;
    info["edges"] = statistics.edges;
    info["boundary_edges"] = statistics.boundaryEdges;
    info["boundary_loops"] = statistics.boundaryLoops;
    info["non_manifold_edges"] = statistics.nonManifoldEdges;
    info["non_manifold_vertices"] = statistics.nonManifoldVertices;
    info["zero_area_triangles"] = zeroAreaTriangles(sequence);
    info["euler"] = statistics.eulerCharacteristic;
    info["uvs"] = sequence.topology->hasUvs();
    info["materials"] = sequence.topology->data().materials;
    info["textures"] = textureJson(sequence.textures);
    info["bounds"] = boundsJson(sequence, progress);
    info["up_axis"] = toString(coordinates.up);
    info["metres_per_unit"] = coordinates.metresPerUnit;
    info["problems"] = Json::array();
    for (const Issue& issue : imported.issues) {
        if (issue.severity == Issue::Severity::Warning)
            info["problems"].push_back(issue.toString());
    }
    return info;
}

std::string infoText(const Json& info)
{
    const auto count = [&info](const char* key, const char* one, const char* many) {
        return counted(info[key].get<std::int64_t>(), one, many);
    };
    std::string out = info["path"].get<std::string>() + " – " + info["name"].get<std::string>() + "\n";
    out += "  " + count("vertices", "vertex", "vertices") + ", " +
           count("triangles", "triangle", "triangles") + ", " +
           count("components", "component", "components") + ", ";
    out += info["boundary_edges"] == 0 ? "closed"
                                       : count("boundary_edges", "boundary edge", "boundary edges") + " in " +
                                             count("boundary_loops", "loop", "loops");
    if (info["non_manifold_edges"] != 0)
        out += ", " + count("non_manifold_edges", "non-manifold edge", "non-manifold edges");
    out += "\n  " + count("frames", "frame", "frames") + rateText(info) + "\n  ";
    out += info["uvs"].get<bool>() ? "UVs, " : "no UVs, ";
    out += textureText(info["textures"]) + "\n  " + boundsText(info);
    for (const Json& problem : info["problems"])
        out += "\n  problem: " + problem.get<std::string>();
    return out;
}

} // namespace quadrille::cli
