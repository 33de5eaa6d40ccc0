// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/projectguard.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/project/document/paths.h"
#include "model/project/json/jsontext.h"
#include "model/project/media/cameratable.h"
#include "model/project/media/media.h"
#include "model/project/media/opensequence.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/mesh/mtl.h"
#include "model/sequence/io/registry.h"

#include <algorithm>
#include <sstream>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

fs::path fileOfWritten(const fs::path& projectFile)
{
    return cacheFolder(projectFile) / "written.json";
}

/// Hashes by stored path; empty when nothing is known.
Json readWritten(const fs::path& projectFile)
{
    try {
        const fs::path file = fileOfWritten(projectFile);
        Json json = parseJson(readFile(file).text(), file).document;
        if (json.is_object() && json.contains("files") && json["files"].is_object())
            return json["files"];
    } catch (const Error&) {
        // Missing or damaged: then nothing is known.
    }
    return Json::object();
}

void knowWritten(WriteGuard& guard, const Project& project, const fs::path& projectFile)
{
    const fs::path folder = projectFolder(projectFile);
    const ResultStore store(cacheFolder(projectFile));
    for (const ExportEntry& entry : project.exports) {
        try {
            const ResultPointer written = store.load("exports/" + entry.name, {}).result;
            for (const WrittenFile& file : written->files)
                guard.know(resolvePath(file.path, folder), file.hash);
        } catch (const Error&) {
            continue; // a result that cannot be read knows nothing
        }
    }
    const Json written = readWritten(projectFile);
    for (const auto& [path, hash] : written.items()) {
        if (hash.is_string())
            guard.know(resolvePath(path, folder), hash.get<std::string>());
    }
}

/// The material libraries that an OBJ file names.
std::vector<fs::path> librariesOf(const fs::path& file)
{
    constexpr std::size_t headBytes = std::size_t{64} << 10;
    std::vector<fs::path> libraries;
    try {
        const InputFile input(file);
        std::string head(std::min<std::uint64_t>(input.size(), headBytes), '\0');
        input.read(0, std::as_writable_bytes(std::span(head)));
        std::istringstream lines(head);
        for (std::string line; std::getline(lines, line);) {
            while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
                line.pop_back();
            if (line.starts_with("mtllib "))
                libraries.push_back(resolveNamedFile(file.parent_path(), line.substr(7)));
        }
    } catch (const Error&) {
        return {}; // it is protected itself; what it names cannot be known
    }
    return libraries;
}

/// The files of a medium that are read: those of a folder's series, not what else lies there.
std::vector<fs::path> framesOf(const fs::path& medium)
{
    std::error_code error;
    if (fs::is_directory(medium, error)) {
        try {
            return findSource(medium).files;
        } catch (const Error&) {
            return filesOfMedium(medium); // of pictures
        }
    }
    return filesOfMedium(medium);
}

/// What media name themselves: libraries and pictures.
std::vector<ProtectedFile> namedByMedia(const Project& project, const fs::path& folder)
{
    std::vector<ProtectedFile> files;
    const auto add = [&files](const fs::path& file, const std::string& what) {
        if (file.empty())
            return;
        files.push_back({file, what});
        if (lowerExtension(file) != ".obj")
            return;
        for (const fs::path& library : librariesOf(file)) {
            if (!library.empty())
                files.push_back({library, what});
        }
    };
    for (const MediaUse& use : mediaOf(project, folder)) {
        for (const fs::path& file : framesOf(use.file))
            add(file, use.owner);
    }
    SequenceOpener opener(project, folder);
    for (const SequenceEntry& entry : project.sequences) {
        try {
            for (const fs::path& file : opener.filesOf(entry.name))
                add(file, "sequences/" + entry.name);
        } catch (const Error&) {
            continue; // what cannot be opened names nothing
        }
    }
    for (const ProjectionEntry& entry : project.projections) {
        try {
            for (const CameraSeries& series : readCameraTable(resolvePath(entry.cameras, folder), {}, {}))
                for (const auto& [frame, picture] : series.pictures)
                    add(picture, "projections/" + entry.name);
        } catch (const Error&) {
            continue; // the same of tables
        }
    }
    return files;
}

/// Files that would become part of a series or of a folder that is read.
void protectMedium(WriteGuard& guard, const MediaUse& use)
{
    std::error_code error;
    if (fs::is_directory(use.file, error)) {
        std::vector<std::string> endings;
        for (const fs::path& file : framesOf(use.file))
            endings.push_back(lowerExtension(file));
        guard.protectNames({use.file, use.owner}, [endings](const std::string& name) {
            return std::find(endings.begin(), endings.end(), lowerExtension(name)) != endings.end();
        });
    } else if (isPattern(use.file) && !fs::exists(use.file, error)) {
        guard.protectNames({use.file.parent_path(), use.owner},
                           [pattern = use.file.filename().string()](const std::string& name) {
                               return matchesPattern(name, pattern);
                           });
    } else {
        guard.protect({use.file, use.owner});
    }
}

} // namespace

std::shared_ptr<WriteGuard> projectGuard(const Project& project, const fs::path& projectFile,
                                         WritePermissions permissions)
{
    const fs::path folder = projectFolder(projectFile);
    auto guard = std::make_shared<WriteGuard>(permissions);
    guard->confineTo(folder);
    fs::path backup = projectFile;
    backup += ".bak";
    guard->protect({projectFile, "the project"});
    guard->protect({backup, "the backup of the project"});
    guard->protectFolder({cacheFolder(projectFile), "the results of the project"});
    for (const MediaUse& use : mediaOf(project, folder))
        protectMedium(*guard, use);
    guard->protectLater([project, folder] { return namedByMedia(project, folder); });
    knowWritten(*guard, project, projectFile);
    return guard;
}

WrittenNote::~WrittenNote()
{
    try {
        const auto written = m_guard.written();
        if (written.empty())
            return;
        const fs::path folder = resolvedFolder(projectFolder(m_projectFile));
        Json json = Json::object();
        json["format"] = "quadrille-written";
        json["files"] = readWritten(m_projectFile);
        for (const auto& [file, hash] : written)
            json["files"][storedPath(file, folder)] = hash;
        writeAtomically(fileOfWritten(m_projectFile), writeJson(json));
    } catch (const std::exception&) {
        return; // then the files are asked about
    }
}

void checkResultsPlace(const fs::path& projectFile, WritePermissions permissions)
{
    WriteGuard guard(permissions);
    guard.confineTo(projectFolder(projectFile));
    guard.checkFolder(cacheFolder(projectFile));
}

} // namespace quadrille
