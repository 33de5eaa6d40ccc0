// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/objectreader.h"

#include "model/project/document/problemtexts.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::optional<std::int64_t> ObjectReader::wholeNumber(std::string_view key, double below) const
{
    const Json* value = find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number() && value->get<double>() == std::floor(value->get<double>()) &&
        std::abs(value->get<double>()) < below)
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

std::vector<int> ObjectReader::wholeNumbers(std::string_view key) const
{
    constexpr auto expected = "a list of whole numbers from zero";
    std::vector<int> whole;
    for (const double number : numbers(key, 0, expected).value_or(std::vector<double>{})) {
        if (number < 0 || number != std::floor(number) || number > std::numeric_limits<int>::max()) {
            wrongType(key, expected);
            return {};
        }
        whole.push_back(static_cast<int>(number));
    }
    return whole;
}

std::vector<std::string> ObjectReader::texts(std::string_view key, const char* expected) const
{
    std::vector<std::string> all;
    each(key, [&](const Json& text, const std::string& pointer) {
        if (text.is_string())
            all.push_back(text.get<std::string>());
        else
            invalid(pointer, expected);
    });
    return all;
}

std::optional<FrameChoice> ObjectReader::choice() const
{
    FrameChoice choice{.label = text("label"), .sequence = text("sequence"), .range = range("range")};
    if (!choice.label.empty() && !choice.sequence.empty())
        invalid(pointer("sequence"), "“label” and “sequence” stand together here", "Keep one of them.");
    if (choice.range && choice.sequence.empty())
        invalid(pointer("range"), "The range belongs to no sequence", "Name the “sequence”.");
    return choice.saysNothing() ? std::nullopt : std::optional(choice);
}

std::vector<JunctionEntry> ObjectReader::junctions(std::string_view key) const
{
    const auto isFrame = [](const Json& json) {
        return json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_number_integer();
    };
    const auto frameOf = [](const Json& json) {
        return NamedFrame{json[0].get<std::string>(), FrameIndex(json[1].get<std::int64_t>())};
    };
    std::vector<JunctionEntry> junctions;
    each(key, [&](const Json& json, const std::string& pointer) {
        if (json.is_array() && json.size() == 2 && isFrame(json[0]) && isFrame(json[1]))
            junctions.push_back({frameOf(json[0]), frameOf(json[1])});
        else
            invalid(pointer, "A junction is expected here",
                    "Write [[\"SEQUENCE\", FRAME], [\"SEQUENCE\", FRAME]].");
    });
    return junctions;
}

Json ObjectReader::unknown(Keys known) const
{
    Json rest;
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
    const auto meant = closestWord(key, known);
    const bool isMisspelt = meant && !json.contains(*meant);
    auto warning =
        warningAt(std::move(pointer), "The key “" + key + "” is not known here and has no effect",
                  isMisspelt ? "Did you mean “" + *meant + "”?"
                             : "Leave it out; a note of your own begins with _, as in “_" + key + "”.");
    warning.atKey = true;
    return warning;
}

} // namespace quadrille
