// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/brokenentry.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace quadrille {

namespace {

using Kept = nlohmann::ordered_json;

} // namespace

std::string BrokenEntry::name() const
{
    for (const char* key : {"name", "character", "table"}) {
        if (!json.contains(key) || !json.json()[key].is_string())
            continue;
        if (auto found = json.json()[key].get<std::string>(); !found.empty())
            return found;
    }
    return {};
}

std::string BrokenEntry::title() const
{
    if (const std::string own = name(); !own.empty())
        return section + "/" + own;
    return place ? section + "/" + std::to_string(*place + 1) : section;
}

std::vector<BrokenEntry> brokenEntries(const Project& project)
{
    std::vector<BrokenEntry> entries;
    if (!project.unknown.contains(brokenEntriesKey))
        return entries;
    for (const Kept& kept : project.unknown.json()[brokenEntriesKey]) {
        BrokenEntry entry{kept["section"].get<std::string>(), {}, UnknownKeys(kept["json"]), {}};
        if (kept.contains("place"))
            entry.place = kept["place"].get<std::size_t>();
        const Kept& problem = kept["problem"];
        entry.problem.code = static_cast<ErrorCode>(problem["code"].get<int>());
        entry.problem.pointer = problem["pointer"].get<std::string>();
        ErrorContext& context = entry.problem.context;
        context.file = problem["file"].get<std::string>();
        if (problem.contains("line"))
            context.place.line = problem["line"].get<std::int64_t>();
        if (problem.contains("column"))
            context.place.column = problem["column"].get<std::int64_t>();
        for (const auto& [name, value] : problem["values"].items())
            context.values.emplace_back(name, value.get<std::string>());
        entries.push_back(std::move(entry));
    }
    return entries;
}

void setBrokenEntries(Project& project, const std::vector<BrokenEntry>& entries)
{
    project.unknown = unknownKeys(project);
    Kept list;
    for (const BrokenEntry& entry : entries) {
        const ErrorContext& context = entry.problem.context;
        Kept problem{{"code", static_cast<int>(entry.problem.code)},
                     {"pointer", entry.problem.pointer},
                     {"file", context.file.string()},
                     {"values", Kept::object()}};
        if (context.place.line)
            problem["line"] = *context.place.line;
        if (context.place.column)
            problem["column"] = *context.place.column;
        for (const auto& [name, value] : context.values)
            problem["values"][name] = value;
        Kept kept{{"section", entry.section}, {"json", entry.json.json()}, {"problem", std::move(problem)}};
        if (entry.place)
            kept["place"] = *entry.place;
        list.push_back(std::move(kept));
    }
    if (!entries.empty())
        project.unknown.set(brokenEntriesKey, std::move(list));
}

UnknownKeys unknownKeys(const Project& project)
{
    UnknownKeys keys = project.unknown;
    keys.erase(brokenEntriesKey);
    return keys.json().empty() ? UnknownKeys() : keys;
}

std::vector<std::string> titlesOf(const std::vector<BrokenEntry>& entries)
{
    std::set<std::string> taken;
    std::vector<std::string> titles;
    for (const BrokenEntry& entry : entries) {
        std::string title = entry.title();
        for (int number = 2; !taken.insert(title).second; ++number)
            title = entry.title() + " (" + std::to_string(number) + ")";
        titles.push_back(std::move(title));
    }
    return titles;
}

std::optional<BrokenEntry> findBroken(const Project& project, const std::string& title)
{
    std::vector<BrokenEntry> entries = brokenEntries(project);
    const std::vector<std::string> titles = titlesOf(entries);
    const auto found = std::find(titles.begin(), titles.end(), title);
    if (found == titles.end())
        return std::nullopt;
    return std::move(entries[static_cast<std::size_t>(found - titles.begin())]);
}

} // namespace quadrille
