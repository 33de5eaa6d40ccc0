// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/groundpoint.h"
#include "model/project/fields/codecs.h"
#include "model/project/json/jsonmembers.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr auto twoCoordinates = "two coordinates on the ground, in the project's unit";

std::optional<Vec2d> readGroundPoint(const ObjectReader& reader, const std::string& key)
{
    const auto numbers = reader.numbers(key, 2, twoCoordinates);
    return numbers ? std::optional(Vec2d((*numbers)[0], (*numbers)[1])) : std::nullopt;
}

/// Points of two numbers each, or of three where `inSpace` comes out true.
std::vector<Vec3d> readPoints(const ObjectReader& reader, std::string_view key, bool& inSpace)
{
    std::vector<Vec3d> points;
    reader.each(key, [&](const Json& json, const std::string& pointer) {
        const bool isPoint =
            json.is_array() && (json.size() == 2 || json.size() == 3) &&
            std::all_of(json.begin(), json.end(), [](const Json& number) { return number.is_number(); });
        if (!isPoint) {
            reader.invalid(pointer, "A point in brackets is expected here",
                           "Write two coordinates on the ground, or three in space, in the project's unit.");
            return;
        }
        if (points.empty())
            inSpace = json.size() == 3;
        else if (inSpace != (json.size() == 3))
            reader.invalid(pointer, "The points of a path must all have two coordinates, or all three");
        points.emplace_back(json[0].get<double>(), json[1].get<double>(),
                            json.size() == 3 ? json[2].get<double>() : 0.0);
    });
    return points;
}

Json pairJson(const Vec2d& point)
{
    return Json::array({point.x(), point.y()});
}

Json listSchema(const char* item, int leastItems)
{
    return {{"type", "array"}, {"items", {{"$ref", item}}}, {"minItems", leastItems}};
}

} // namespace

void readValue(const ObjectReader& reader, const std::string& key, Vec3d& point, const FieldContext&)
{
    if (const auto numbers = reader.numbers(key, 3, "three coordinates, [x, y, z]"))
        point = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

void writeValue(Json& json, const std::string& key, const Vec3d& point, const FieldContext&)
{
    json[key] = {point.x(), point.y(), point.z()};
}

void valueSchema(Json& properties, const std::string& key, Type<Vec3d>)
{
    properties[key]["$ref"] = "#/definitions/point";
}

void readValue(const ObjectReader& reader, const std::string& key, std::optional<Vec2d>& point,
               const FieldContext&)
{
    point = readGroundPoint(reader, key);
}

void writeValue(Json& json, const std::string& key, const std::optional<Vec2d>& point, const FieldContext&)
{
    if (point)
        json[key] = pairJson(*point);
}

void valueSchema(Json& properties, const std::string& key, Type<std::optional<Vec2d>>)
{
    properties[key]["$ref"] = "#/definitions/ground_point";
}

void readValue(const ObjectReader& reader, const std::string& key, PathEntry& path,
               const FieldContext& context)
{
    path.points = readPoints(reader, key, path.inSpace);
    if (path.inSpace)
        return;
    for (Vec3d& point : path.points)
        point = pointOnGround(point.head<2>(), context.axes.up);
}

void writeValue(Json& json, const std::string& key, const PathEntry& path, const FieldContext& context)
{
    json[key] = Json::array();
    for (const Vec3d& point : path.points)
        json[key].push_back(path.inSpace ? Json::array({point.x(), point.y(), point.z()})
                                         : pairJson(pointOfFile(point, context.axes.up)));
}

void valueSchema(Json& properties, const std::string& key, Type<PathEntry>)
{
    properties[key] = listSchema("#/definitions/path_point", 2);
}

std::vector<std::string> valueKeys(const std::string&, Type<ObstacleEntry>)
{
    return {"centre", "radius", "polygon"};
}

void readValue(const ObjectReader& reader, const std::string&, ObstacleEntry& obstacle, const FieldContext&)
{
    if (reader.find("polygon") != nullptr) {
        bool inSpace = false;
        for (const Vec3d& corner : readPoints(reader, "polygon", inSpace))
            obstacle.corners.emplace_back(corner.head<2>());
        if (inSpace)
            reader.wrongType("polygon", "a list of points with " + std::string(twoCoordinates));
        return;
    }
    const auto centre = readGroundPoint(reader, "centre");
    if (!centre)
        reader.missing("centre");
    obstacle.corners = {centre.value_or(Vec2d::Zero())};
    const auto radius = reader.number("radius");
    if (!radius)
        reader.missing("radius");
    obstacle.radius = radius.value_or(0);
}

void writeValue(Json& json, const std::string&, const ObstacleEntry& obstacle, const FieldContext&)
{
    if (obstacle.isDisc()) {
        json["centre"] = pairJson(obstacle.corners.front());
        json["radius"] = obstacle.radius;
        return;
    }
    json["polygon"] = Json::array();
    for (const Vec2d& corner : obstacle.corners)
        json["polygon"].push_back(pairJson(corner));
}

void valueSchema(Json& properties, const std::string&, Type<ObstacleEntry>)
{
    properties["centre"]["$ref"] = "#/definitions/ground_point";
    properties["radius"] = {{"description", "In the project's unit."},
                            {"type", "number"},
                            {"exclusiveMinimum", 0},
                            {"maximum", 10'000'000}};
    properties["polygon"] = listSchema("#/definitions/ground_point", 3);
}

std::vector<std::string> valueKeys(const std::string&, Type<RetimeSettings>)
{
    return {"factor", "duration", "curve"};
}

void readValue(const ObjectReader& reader, const std::string&, RetimeSettings& retime, const FieldContext&)
{
    int ways = 0;
    if (const auto factor = reader.number("factor")) {
        retime.time = RetimeFactor{*factor};
        ++ways;
    }
    if (const auto duration = reader.number("duration")) {
        retime.time = Seconds{*duration};
        ++ways;
    }
    if (reader.find("curve") != nullptr) {
        bool inSpace = false;
        RetimeSettings::Curve curve;
        for (const Vec3d& point : readPoints(reader, "curve", inSpace))
            curve.push_back({Seconds{point.x()}, Seconds{point.y()}});
        retime.time = std::move(curve);
        ++ways;
    }
    if (ways > 1)
        reader.invalid(reader.pointer(), "The time is given in several ways",
                       "Keep one of “factor”, “duration” and “curve”.");
}

void writeValue(Json& json, const std::string&, const RetimeSettings& retime, const FieldContext&)
{
    if (const auto* factor = std::get_if<RetimeFactor>(&retime.time))
        json["factor"] = factor->value;
    else if (const auto* duration = std::get_if<Seconds>(&retime.time))
        json["duration"] = duration->value;
    else
        for (const RetimePoint& point : std::get<RetimeSettings::Curve>(retime.time))
            json["curve"].push_back(Json::array({point.output.value, point.clip.value}));
}

void valueSchema(Json& properties, const std::string&, Type<RetimeSettings>)
{
    properties["factor"] = {{"description", "Of the duration."}, {"type", "number"}, {"exclusiveMinimum", 0}};
    properties["duration"]["$ref"] = "#/definitions/seconds";
    properties["curve"] = {
        {"type", "array"},
        {"minItems", 2},
        {"items", {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}}}};
}

} // namespace quadrille
