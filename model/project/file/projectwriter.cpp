// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/brokenentry.h"
#include "model/project/fields/readfields.h"
#include "model/project/fields/writefields.h"
#include "model/project/file/projectjson.h"
#include "model/project/json/jsontext.h"

#include <algorithm>

namespace quadrille {

namespace {

/// Puts broken entries back to where they stood.
void addBroken(Json& json, const std::vector<BrokenEntry>& broken)
{
    for (const BrokenEntry& entry : broken) {
        Json& section = json[entry.section];
        if (!entry.place && (section.empty() || entry.section == "settings")) {
            section = entry.json.json();
            continue;
        }
        if (!section.is_array())
            section = section.is_null() ? Json::array() : Json::array({section});
        const auto place = std::min(entry.place.value_or(0), section.size());
        section.insert(section.begin() + static_cast<std::ptrdiff_t>(place), entry.json.json());
    }
}

/// The keys in the order in which they are written.
Json inOrder(Json json)
{
    Json ordered = Json::object();
    for (const std::string& known : documentKeys()) {
        if (const auto found = json.find(known); found != json.end())
            ordered[known] = std::move(*found);
    }
    for (auto& [key, value] : json.items()) {
        if (!ordered.contains(key))
            ordered[key] = std::move(value);
    }
    return ordered;
}

} // namespace

Json projectToJson(const Project& project, WrittenEntries entries)
{
    Json json = writeFields(project);
    json.erase(brokenEntriesKey);
    const std::vector<BrokenEntry> broken = brokenEntries(project);
    if (entries == WrittenEntries::Usable || broken.empty())
        return json;
    addBroken(json, broken);
    return inOrder(std::move(json));
}

} // namespace quadrille
