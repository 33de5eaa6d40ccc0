// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/pictureoptions.h"

#include "model/project/objectreader.h"
#include "model/project/projectkeys.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

template <typename Enum, std::size_t count>
using Names = std::array<std::pair<std::string_view, Enum>, count>;

using Shading = RenderOptions::Shading;
using Background = RenderOptions::Background;

constexpr Names<Shading, 4> shadings{{{"textured", Shading::Textured},
                                      {"flat", Shading::Flat},
                                      {"clay", Shading::Clay},
                                      {"wireframe", Shading::Wireframe}}};
constexpr Names<Background, 3> backgrounds{
    {{"light", Background::Light}, {"dark", Background::Dark}, {"transparent", Background::Transparent}}};
constexpr Names<CameraMode, 3> cameras{
    {{"turntable", CameraMode::Turntable}, {"fixed", CameraMode::Fixed}, {"follow", CameraMode::Follow}}};
constexpr int largestSide = 16384;

/// Takes values out of an object and reports those that cannot be used.
class PictureReader
{
public:
    PictureReader(const Json& json, std::string pointer, ProjectProblems& problems)
        : m_json(json), m_pointer(std::move(pointer)), m_problems(problems)
    {
        if (!json.is_object())
            m_problems.push_back(invalidAt(m_pointer, "An object in braces is expected here"));
    }

    const Json* find(const char* key) const
    {
        const auto found = m_json.find(key);
        return m_json.is_object() && found != m_json.end() ? &*found : nullptr;
    }
    std::string pointer(const std::string& key) const { return m_pointer + "/" + escapePointer(key); }
    void wrong(const char* key, const std::string& expected) const
    {
        std::string reason = "“";
        reason.append(key).append("” must be ").append(expected);
        m_problems.push_back(invalidAt(pointer(key), std::move(reason)));
    }

    void side(const char* key, int& out) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        if (value->is_number_integer() && *value >= 1 && *value <= largestSide)
            out = value->get<int>();
        else
            wrong(key, "a number of pixels from 1 to " + std::to_string(largestSide));
    }
    void number(const char* key, double& out, double lowest, double highest) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        if (value->is_number() && value->get<double>() >= lowest && value->get<double>() <= highest)
            out = value->get<double>();
        else
            wrong(key, "a number from " + Json(lowest).dump() + " to " + Json(highest).dump());
    }
    void boolean(const char* key, bool& out) const
    {
        const Json* value = find(key);
        if (value != nullptr && value->is_boolean())
            out = value->get<bool>();
        else if (value != nullptr)
            wrong(key, "true or false");
    }
    template <typename Enum, std::size_t count>
    void word(const char* key, Enum& out, const Names<Enum, count>& names) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        std::string known;
        for (const auto& [name, meaning] : names) {
            if (*value == name) {
                out = meaning;
                return;
            }
            known.append(known.empty() ? "\"" : ", \"").append(name).append("\"");
        }
        wrong(key, "one of " + known);
    }
    void point(const char* key, Vec3d& out) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        const bool fits =
            value->is_array() && value->size() == 3 &&
            std::all_of(value->begin(), value->end(), [](const Json& number) { return number.is_number(); });
        if (fits)
            out = {(*value)[0].get<double>(), (*value)[1].get<double>(), (*value)[2].get<double>()};
        else
            wrong(key, "three numbers, [x, y, z]");
    }
    void warnOfUnknown(std::span<const std::string_view> known) const
    {
        if (!m_json.is_object())
            return;
        for (const auto& [key, value] : m_json.items()) {
            if (std::find(known.begin(), known.end(), key) != known.end())
                continue;
            if (auto warning = warningOfUnknown(m_json, key, pointer(key), known))
                m_problems.push_back(std::move(*warning));
        }
    }

private:
    const Json& m_json;
    std::string m_pointer;
    ProjectProblems& m_problems;
};

template <typename Enum, std::size_t count>
std::string_view nameOf(Enum value, const Names<Enum, count>& names)
{
    return std::find_if(names.begin(), names.end(),
                        [value](const auto& name) { return name.second == value; })
        ->first;
}

Json pointToJson(const Vec3d& point)
{
    return Json::array({point.x(), point.y(), point.z()});
}

} // namespace

RenderSettings pictureFromJson(const Json& json, const std::string& pointer, ProjectProblems& problems)
{
    RenderSettings settings;
    if (json.is_null())
        return settings;
    const PictureReader reader(json, pointer, problems);
    reader.side("width", settings.look.width);
    reader.side("height", settings.look.height);
    reader.word("shading", settings.look.shading, shadings);
    reader.word("background", settings.look.background, backgrounds);
    reader.boolean("grid", settings.look.grid);
    reader.word("camera", settings.camera, cameras);
    reader.number("revolutions", settings.revolutions, -1000, 1000);
    if (const Json* view = reader.find("view")) {
        Camera camera;
        const PictureReader viewReader(*view, reader.pointer("view"), problems);
        viewReader.point("eye", camera.eye);
        viewReader.point("target", camera.target);
        viewReader.point("up", camera.up);
        viewReader.number("fov", camera.verticalFovDegrees, 1, 170);
        viewReader.warnOfUnknown(projectkeys::view);
        if (const double distance = (camera.eye - camera.target).norm(); distance > 0) {
            camera.nearDistance = distance / 100;
            camera.farDistance = distance * 1000;
        }
        settings.view = camera;
    }
    reader.warnOfUnknown(projectkeys::picture);
    return settings;
}

Json pictureToJson(const RenderSettings& settings)
{
    Json json = Json::object();
    json["width"] = settings.look.width;
    json["height"] = settings.look.height;
    json["shading"] = nameOf(settings.look.shading, shadings);
    json["background"] = nameOf(settings.look.background, backgrounds);
    json["grid"] = settings.look.grid;
    json["camera"] = nameOf(settings.camera, cameras);
    json["revolutions"] = settings.revolutions;
    if (settings.view) {
        json["view"]["eye"] = pointToJson(settings.view->eye);
        json["view"]["target"] = pointToJson(settings.view->target);
        json["view"]["up"] = pointToJson(settings.view->up);
        json["view"]["fov"] = settings.view->verticalFovDegrees;
    }
    return json;
}

} // namespace quadrille
