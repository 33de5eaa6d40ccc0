// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/objectreader.h"

#include "model/project/lengthunit.h"
#include "model/project/projectkeys.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

ObjectReader::ObjectReader(const Json& json, std::string pointer, ProjectProblems& problems)
    : m_json(json), m_pointer(std::move(pointer)), m_problems(problems)
{
    if (!json.is_object())
        invalid(m_pointer, "An object in braces is expected here");
}

const Json* ObjectReader::find(std::string_view key) const
{
    if (!m_json.is_object())
        return nullptr;
    const auto found = m_json.find(std::string(key));
    return found == m_json.end() ? nullptr : &*found;
}

std::string ObjectReader::pointer(std::string_view key) const
{
    return m_pointer + "/" + escapePointer(key);
}

void ObjectReader::invalid(const std::string& pointer, std::string reason, std::string remedy) const
{
    m_problems.push_back(invalidAt(pointer, std::move(reason), std::move(remedy)));
}

void ObjectReader::wrongType(std::string_view key, const std::string& expected) const
{
    invalid(pointer(key), "“" + std::string(key) + "” must be " + expected);
}

void ObjectReader::missing(std::string_view key) const
{
    invalid(pointer(key), "“" + std::string(key) + "” is missing here");
}

std::string ObjectReader::text(std::string_view key) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return {};
    if (value->is_string())
        return value->get<std::string>();
    wrongType(key, "text in quotes");
    return {};
}

std::string ObjectReader::requiredText(std::string_view key) const
{
    if (m_json.is_object() && find(key) == nullptr)
        missing(key);
    return text(key);
}

std::optional<double> ObjectReader::number(std::string_view key) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number())
        return value->get<double>();
    wrongType(key, "a number");
    return std::nullopt;
}

std::optional<std::int64_t> ObjectReader::wholeNumber(std::string_view key) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number() && value->get<double>() == std::floor(value->get<double>()) &&
        std::abs(value->get<double>()) < 2e9)
        return static_cast<std::int64_t>(value->get<double>());
    wrongType(key, "a whole number");
    return std::nullopt;
}

bool ObjectReader::boolean(std::string_view key, bool fallback) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return fallback;
    if (value->is_boolean())
        return value->get<bool>();
    wrongType(key, "true or false");
    return fallback;
}

std::optional<FrameRange> ObjectReader::range(std::string_view key) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    const auto isFrame = [](const Json& item) {
        return item.is_number_integer() && item.get<double>() >= 0 && item.get<double>() < 1e15;
    };
    if (value->is_array() && value->size() == 2 && isFrame((*value)[0]) && isFrame((*value)[1]))
        return FrameRange{FrameIndex((*value)[0].get<std::int64_t>()),
                          FrameIndex((*value)[1].get<std::int64_t>())};
    wrongType(key, "two frame numbers, [first, last]");
    return std::nullopt;
}

std::optional<std::vector<double>> ObjectReader::numbers(std::string_view key, std::size_t count,
                                                         const std::string& expected) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_array() && (count == 0 || value->size() == count) &&
        std::all_of(value->begin(), value->end(), [](const Json& item) { return item.is_number(); }))
        return value->get<std::vector<double>>();
    wrongType(key, expected);
    return std::nullopt;
}

std::optional<UpAxis> ObjectReader::upAxis(std::string_view key) const
{
    if (find(key) == nullptr)
        return std::nullopt;
    const auto axis = upAxisFromString(text(key));
    if (!axis && find(key)->is_string())
        wrongType(key, "\"x\", \"y\" or \"z\"");
    return axis;
}

std::optional<double> ObjectReader::unit(std::string_view key) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number() && value->get<double>() > 0 && std::isfinite(value->get<double>()))
        return value->get<double>();
    if (value->is_string()) {
        if (const auto metres = metresPerUnit(value->get<std::string>()))
            return metres;
    }
    wrongType(key, "\"m\", \"cm\", \"mm\", \"km\", \"in\", \"ft\" or the metres that one unit has");
    return std::nullopt;
}

std::optional<CoordinateSystem> ObjectReader::axes(std::string_view upKey, std::string_view unitKey,
                                                   const CoordinateSystem& fallback) const
{
    const auto up = upAxis(upKey);
    const auto metres = unit(unitKey);
    if (!up && !metres)
        return std::nullopt;
    return CoordinateSystem{up.value_or(fallback.up), metres.value_or(fallback.metresPerUnit)};
}

UnknownKeys ObjectReader::unknown(Keys known) const
{
    UnknownKeys rest;
    if (!m_json.is_object())
        return rest;
    for (const auto& [key, value] : m_json.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end())
            continue;
        rest[key] = value;
        if (auto warning = warningOfUnknown(m_json, key, pointer(key), known))
            m_problems.push_back(std::move(*warning));
    }
    return rest;
}

std::optional<ProjectProblem> warningOfUnknown(const Json& json, const std::string& key, std::string pointer,
                                               ObjectReader::Keys known)
{
    if (key.starts_with('_'))
        return std::nullopt;
    const auto meant = projectkeys::closestWord(key, known);
    const bool isMisspelt = meant && !json.contains(*meant);
    auto warning =
        warningAt(std::move(pointer), "The key “" + key + "” is not known here and has no effect",
                  isMisspelt ? "Did you mean “" + *meant + "”?"
                             : "Leave it out; a note of your own begins with _, as in “_" + key + "”.");
    warning.atKey = true;
    return warning;
}

} // namespace quadrille
