// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/importsequences.h"

#include "model/core/message.h"
#include "model/project/document/entryname.h"
#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"
#include "model/project/fields/references.h"
#include "model/project/file/projectfile.h"
#include "model/project/file/projectlock.h"
#include "model/project/file/usableproject.h"
#include "model/project/media/opensequence.h"
#include "model/sequence/io/registry.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throwBadArgument(const fs::path& file, std::string reason, std::string remedy)
{
    throw Error(ErrorCode::BadArgument,
                {file, {}, {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
}

CharacterEntry* findCharacter(Project& project, const std::string& name)
{
    const auto found = std::find_if(project.characters.begin(), project.characters.end(),
                                    [&](const CharacterEntry& entry) { return entry.name == name; });
    return found == project.characters.end() ? nullptr : &*found;
}

/// A name for a character that nobody named: the mesh's, or its folder's where it is just "mesh".
std::string characterName(const ImportRequest& request)
{
    const fs::path& file = request.mesh.empty() ? request.sources.front() : request.mesh;
    const fs::path absolute = fs::absolute(file).lexically_normal();
    const std::string stem = absolute.stem().string();
    const std::string folder = absolute.parent_path().filename().string();
    const bool plain = stem == "mesh" || request.mesh.empty();
    return plain && !problemWithName(folder) ? folder : stem;
}

/// The character that the sequences belong to, with its mesh.
CharacterEntry& characterFor(Project& project, const fs::path& folder, const ImportRequest& request)
{
    CharacterEntry* character = nullptr;
    if (!request.character.empty())
        character = findCharacter(project, request.character);
    else if (project.characters.size() == 1)
        character = &project.characters.front();
    else if (project.characters.size() > 1)
        throwBadArgument({}, QUADRILLE_MESSAGE("The project has several characters"),
                         QUADRILLE_MESSAGE("Name one of them."));
    const std::string mesh = request.mesh.empty() ? "" : storedPath(request.mesh, folder);
    if (character == nullptr) {
        CharacterEntry added;
        added.name = request.character.empty() ? characterName(request) : request.character;
        if (const auto problem = problemWithName(added.name))
            throwBadArgument({}, *problem, QUADRILLE_MESSAGE("Give the character another name."));
        added.mesh = mesh;
        project.characters.push_back(std::move(added));
        return project.characters.back();
    }
    if (!mesh.empty() && !character->mesh.empty() && character->mesh != mesh) {
        throwBadArgument(request.mesh, "“" + character->name + "” has another mesh, " + character->mesh,
                         QUADRILLE_MESSAGE("Leave the mesh out, or name another character."));
    }
    if (character->mesh.empty())
        character->mesh = mesh;
    return *character;
}

std::string freeName(const Project& project, std::string wanted)
{
    std::replace(wanted.begin(), wanted.end(), '/', '-');
    std::replace(wanted.begin(), wanted.end(), '\\', '-');
    if (problemWithName(wanted))
        wanted = "sequence";
    std::string name = wanted;
    for (int number = 2; findSequence(project, name) != nullptr; ++number)
        name = wanted + "-" + std::to_string(number);
    return name;
}

SequenceEntry entryOf(const MeshSequence& sequence, const fs::path& source, const fs::path& folder,
                      const ImportRequest& request, bool severalClips)
{
    SequenceEntry entry;
    entry.name = request.name.empty() ? sequence.name : request.name;
    entry.source = storedPath(source, folder);
    if (severalClips)
        entry.clip = sequence.name;
    entry.sourceFps = request.sourceFps;
    entry.sourceAxes = request.sourceAxes;
    return entry;
}

/// The rate of the takes of a character whose files name none, where there are some.
std::optional<double> rateOfOthers(const Project& project, const std::string& character)
{
    for (auto entry = project.sequences.rbegin(); entry != project.sequences.rend(); ++entry) {
        const CharacterEntry* its = characterOf(project, *entry);
        if (!clipOfSource(entry->source) && (its == nullptr || its->name == character))
            return entry->sourceFps.value_or(project.settings.fps);
    }
    return std::nullopt;
}

} // namespace

TakenRate takenRate(std::optional<RateBeside> beside, const Project& project, const std::string& character)
{
    TakenRate rate{.sequence = {}, .fps = project.settings.fps, .beside = std::move(beside)};
    if (rate.beside) {
        rate.fps = rate.beside->fps;
    } else if (const auto others = rateOfOthers(project, character)) {
        rate.fps = *others;
        rate.isOfOthers = true;
    }
    return rate;
}

std::string TakenRate::toString() const
{
    const std::string name = "“" + sequence + "”";
    if (beside)
        return name + " has " + beside->toString();
    std::string number = std::to_string(fps);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.ends_with('.'))
        number.pop_back();
    if (isOfOthers)
        return name + " is taken to have " + number + " fps, as the takes before it; its file names no rate";
    return "The rate of " + name + " is not known: neither its file nor what lies beside it names one; " +
           number + " fps is taken";
}

ImportReport addSequences(Project& project, const fs::path& folder, const ImportRequest& request, bool isNew,
                          const Progress& progress)
{
    Project changed = project;
    // What left its character out still means the one that was alone.
    const bool addsCharacter =
        !request.character.empty() && findCharacter(changed, request.character) == nullptr;
    if (addsCharacter && changed.characters.size() == 1)
        nameOnlyCharacter(changed);
    const CharacterEntry character = characterFor(changed, folder, request);
    ImportReport report;
    report.isNewProject = isNew;
    const auto count = static_cast<double>(request.sources.size());
    for (std::size_t i = 0; i < request.sources.size(); ++i) {
        const Progress part =
            progress.part(0.7 * static_cast<double>(i) / count, 0.7 * static_cast<double>(i + 1) / count);
        ImportOptions options;
        options.mesh = resolvePath(character.mesh, folder);
        options.fps = request.sourceFps.value_or(changed.settings.fps);
        options.from = request.sourceAxes;
        const ImportResult imported = openSequences(request.sources[i], options, part);
        const MeshSequence& first = imported.sequences.front();
        std::optional<TakenRate> taken;
        if (!imported.hasOwnFps && !request.sourceFps && first.frameCount() > 1)
            taken = takenRate(rateBeside(request.sources[i], first.frameCount()), changed, character.name);
        if (isNew && i == 0 && (imported.hasOwnFps || request.sourceFps || taken))
            changed.settings.fps = taken ? taken->fps : first.fps;
        const bool several = imported.sequences.size() > 1;
        for (const MeshSequence& sequence : imported.sequences) {
            SequenceEntry entry = entryOf(sequence, request.sources[i], folder, request, several);
            entry.name = freeName(changed, entry.name);
            if (changed.characters.size() > 1)
                entry.character = character.name;
            if (taken) {
                taken->sequence = entry.name;
                report.rates.push_back(*taken);
                entry.sourceFps = taken->fps;
            }
            if (entry.sourceFps == changed.settings.fps || imported.hasOwnFps)
                entry.sourceFps.reset();
            report.names.push_back(entry.name);
            changed.sequences.push_back(std::move(entry));
        }
    }
    SequenceOpener opener(changed, folder);
    for (const std::string& name : report.names) {
        const auto opened = opener.open(name, Progress(progress.token()));
        report.issues.insert(report.issues.end(), opened->issues.begin(), opened->issues.end());
    }
    project = std::move(changed);
    progress.report(1);
    return report;
}

ImportReport importSequences(const fs::path& projectFile, const ImportRequest& request,
                             const Progress& progress)
{
    std::error_code error;
    const bool isNew = !fs::exists(projectFile, error);
    const ProjectLock lock(projectFile, "quadrille import");
    if (lock.state() == ProjectLock::State::Foreign && !request.ignoresLock)
        throwBadArgument(projectFile, "The project is open elsewhere (" + lock.holder()->toString() + ")",
                         QUADRILLE_MESSAGE("Close it there first, or write all the same with --force."));
    if (isNew && projectFile.extension() != ".quadrille")
        throwBadArgument(projectFile, "A project's name ends in .quadrille", "Name it so.");
    Project project = isNew ? Project{} : loadProject(projectFile);
    ImportReport report = addSequences(project, projectFolder(projectFile), request, isNew, progress);
    const ProjectProblems problems = problemsWhenSaved(project);
    if (!problems.empty())
        throw Error(problems.front().code, problems.front().context);
    saveProject(project, projectFile);
    return report;
}

} // namespace quadrille
