// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/file/projectfile.h"

#include "model/core/file.h"
#include "model/project/checks/validate.h"
#include "model/project/document/brokenentry.h"
#include "model/project/fields/readfields.h"
#include "model/project/file/migration.h"
#include "model/project/file/projectjson.h"

#include <algorithm>
#include <set>

namespace quadrille {

namespace {

/// A section that others speak of must be there, if only to say that it is empty: one that is misspelt would
/// otherwise leave them without what they name.
void requireSequences(const ObjectReader& reader)
{
    if (reader.find("sequences") != nullptr)
        return;
    for (const char* section : {"animations", "variations", "motion_spaces", "transfers", "projections"}) {
        const Json* entries = reader.find(section);
        if (entries == nullptr || entries->empty())
            continue;
        auto problem =
            invalidAt(reader.pointer(section),
                      "The section “sequences” is missing, which “" + std::string(section) + "” needs",
                      "Write \"sequences\": […] with one entry for each take.");
        problem.atKey = true;
        reader.problems().push_back(std::move(problem));
        return;
    }
}

/// An entry whose type is wrong was left at its default; what validate() finds there says nothing new.
bool isInside(const std::string& pointer, const std::set<std::string>& pointers)
{
    return std::any_of(pointers.begin(), pointers.end(), [&](const std::string& outer) {
        return pointer == outer || pointer.starts_with(outer + "/");
    });
}

} // namespace

void sortByPlace(ProjectProblems& problems)
{
    std::stable_sort(problems.begin(), problems.end(), [](const ProjectProblem& a, const ProjectProblem& b) {
        const auto place = [](const ProjectProblem& problem) {
            return std::pair(problem.context.place.line, problem.context.place.column);
        };
        return place(a) < place(b);
    });
}

Project projectFromJson(const Json& document, ProjectProblems& problems)
{
    const ObjectReader reader(document, "", problems);
    requireSequences(reader);
    return readFields(reader);
}

Project readDocument(const Json& document, ProjectProblems& problems)
{
    Project project = projectFromJson(document, problems);
    project.unknown = unknownKeys(project);
    std::set<std::string> wrong;
    for (const ProjectProblem& problem : problems) {
        if (problem.severity == ProjectProblem::Severity::Error)
            wrong.insert(problem.pointer);
    }
    for (ProjectProblem& problem : validate(project)) {
        if (!isInside(problem.pointer, wrong))
            problems.push_back(std::move(problem));
    }
    return project;
}

ProjectReading readProject(std::string_view text, const std::filesystem::path& file)
{
    JsonText json = parseJson(text, file);
    migrate(json, projectMigrations(), Project::currentVersion, file);
    ProjectReading reading;
    reading.project = readDocument(json.document, reading.problems);
    for (ProjectProblem& problem : reading.problems) {
        problem.context.file = file;
        problem.context.place =
            problem.atKey ? json.placeOfKey(problem.pointer) : json.placeOf(problem.pointer);
    }
    sortByPlace(reading.problems);
    return reading;
}

ProjectReading readProject(const std::filesystem::path& file)
{
    return readProject(readFile(file).text(), file);
}

Project loadProject(const std::filesystem::path& file)
{
    ProjectReading reading = readProject(file);
    for (const ProjectProblem& problem : reading.problems) {
        if (problem.severity == ProjectProblem::Severity::Error)
            throw Error(problem.code, problem.context);
    }
    return std::move(reading.project);
}

void saveProject(const Project& project, const std::filesystem::path& file)
{
    namespace fs = std::filesystem;
    std::error_code error;
    // A link keeps pointing at the file it names.
    const fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    const std::string text = writeJson(projectToJson(project));
    if (fs::exists(target, error) && fs::file_size(target, error) > 0) {
        const FileContent before = readFile(target);
        if (before.text() == text)
            return;
        fs::path backup = target;
        backup += ".bak";
        writeAtomically(backup, before.text());
    }
    writeAtomically(target, text);
}

} // namespace quadrille
