// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/usableproject.h"

#include "model/core/utf8.h"
#include "model/project/fields/readfields.h"
#include "model/project/file/migration.h"
#include "model/project/file/projectjson.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace quadrille {

namespace {

/// The part of a document that a JSON pointer leads into: an item of a section's list, or a whole section.
struct Part
{
    std::string section;
    std::optional<std::size_t> item;

    auto operator<=>(const Part&) const = default;
};

Part partAt(const std::string& pointer, const Json& document)
{
    const auto end = std::min(pointer.find('/', 1), pointer.size());
    Part part{pointer.substr(std::min<std::size_t>(1, pointer.size()), end - 1), {}};
    const auto section = document.find(part.section);
    if (end == pointer.size() || section == document.end() || !section->is_array())
        return part;
    std::size_t item = 0;
    const char* text = pointer.c_str() + end + 1;
    if (std::from_chars(text, pointer.c_str() + pointer.size(), item).ec == std::errc() &&
        item < section->size())
        part.item = item;
    return part;
}

/// A document from which parts are taken out, that still knows where the others stood.
class ShrinkingDocument
{
public:
    explicit ShrinkingDocument(Json document) : m_document(std::move(document))
    {
        for (const auto& [section, value] : m_document.items()) {
            for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
                m_places[section].push_back(i);
        }
    }

    const Json& json() const { return m_document; }

    /// A pointer into what is left as one into the whole.
    std::string original(const std::string& pointer) const
    {
        const Part part = partAt(pointer, m_document);
        if (!part.item)
            return pointer;
        const std::string head = "/" + part.section + "/";
        const auto rest = std::min(pointer.find('/', head.size()), pointer.size());
        return head + std::to_string(m_places.at(part.section)[*part.item]) + pointer.substr(rest);
    }

    BrokenEntry take(const Part& part)
    {
        BrokenEntry entry{part.section, {}, {}, {}};
        Json& section = m_document[part.section];
        if (!part.item) {
            entry.json = UnknownKeys(std::move(section));
            m_document.erase(part.section);
            return entry;
        }
        auto& places = m_places[part.section];
        entry.place = places[*part.item];
        entry.json = UnknownKeys(std::move(section[*part.item]));
        section.erase(*part.item);
        places.erase(places.begin() + static_cast<std::ptrdiff_t>(*part.item));
        return entry;
    }

private:
    Json m_document;
    std::map<std::string, std::vector<std::size_t>> m_places;
};

/// By section, in the order in which sections are written, and by place.
void sortByPlace(std::vector<BrokenEntry>& entries)
{
    std::ranges::stable_sort(entries, {}, [](const BrokenEntry& entry) {
        const auto known = documentKeys();
        return std::pair(std::ranges::find(known, entry.section) - known.begin(), entry.place);
    });
}

/// A value that the text of a document cannot hold, or not so that it comes back.
struct BadValue
{
    std::string pointer; ///< from the value that was searched
    bool isText = false; ///< else a number
};

std::optional<BadValue> findBadValue(const Json& json)
{
    if (json.is_number_float() && !std::isfinite(json.get<double>()))
        return BadValue{};
    if (json.is_string() && !isUtf8(json.get_ref<const std::string&>()))
        return BadValue{"", true};
    if (json.is_array()) {
        for (std::size_t i = 0; i < json.size(); ++i) {
            if (const auto bad = findBadValue(json[i]))
                return BadValue{"/" + std::to_string(i) + bad->pointer, bad->isText};
        }
    } else if (json.is_object()) {
        for (const auto& [key, value] : json.items()) {
            if (!isUtf8(key))
                return BadValue{"", true};
            if (const auto bad = findBadValue(value))
                return BadValue{"/" + escapePointer(key) + bad->pointer, bad->isText};
        }
    }
    return std::nullopt;
}

ProjectReading usable(const JsonText& text, const std::filesystem::path& file)
{
    ShrinkingDocument rest(text.document);
    ProjectReading reading;
    std::vector<BrokenEntry> broken;
    const auto place = [&](ProjectProblem& problem) {
        problem.pointer = rest.original(problem.pointer);
        problem.context.file = file;
        problem.context.place =
            problem.atKey ? text.placeOfKey(problem.pointer) : text.placeOf(problem.pointer);
    };
    for (bool isFirst = true;; isFirst = false) {
        ProjectProblems problems;
        reading.project = readDocument(rest.json(), problems);
        // One of each section at a time: what is wrong with the next may be its fault.
        std::map<std::string, std::pair<Part, ProjectProblem>> wrong;
        for (ProjectProblem& problem : problems) {
            const bool isError = problem.severity == ProjectProblem::Severity::Error;
            const Part part = partAt(problem.pointer, rest.json());
            place(problem);
            if (isError && (part.section.empty() || !rest.json().contains(part.section)))
                throw Error(problem.code, problem.context);
            if (isError)
                wrong.try_emplace(part.section, part, problem);
            if (!isError && isFirst)
                reading.problems.push_back(std::move(problem));
        }
        for (const auto& [section, found] : wrong) {
            broken.push_back(rest.take(found.first));
            broken.back().problem = found.second;
            reading.problems.push_back(found.second);
        }
        if (wrong.empty())
            break;
    }
    sortByPlace(broken);
    setBrokenEntries(reading.project, broken);
    sortByPlace(reading.problems);
    return reading;
}

} // namespace

ProjectReading readUsableProject(std::string_view text, const std::filesystem::path& file)
{
    JsonText json = parseJson(text, file);
    migrate(json, projectMigrations(), Project::currentVersion, file);
    return usable(json, file);
}

Project withBrokenReadAgain(const Project& project, const std::filesystem::path& file)
{
    return usable(parseJson(writeJson(projectToJson(project)), file), file).project;
}

ProjectProblems problemsWhenSaved(const Project& project)
{
    const Json json = projectToJson(project, WrittenEntries::Usable);
    ProjectProblems problems;
    if (const auto bad = findBadValue(json)) {
        problems.push_back(bad->isText ? invalidAt(bad->pointer, "The letters of a name cannot be saved here",
                                                   "Give the file or entry a name in UTF-8.")
                                       : invalidAt(bad->pointer, "A number is not finite here"));
    }
    readDocument(json, problems);
    std::erase_if(problems, [](const ProjectProblem& problem) {
        return problem.severity != ProjectProblem::Severity::Error;
    });
    return problems;
}

} // namespace quadrille
