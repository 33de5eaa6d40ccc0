// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/carryresults.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/project/document/paths.h"
#include "model/project/store/resultfile.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <functional>
#include <linux/fs.h>
#include <map>
#include <optional>
#include <set>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Makes `to` have the content of `from`; false where it cannot be done this way.
using Give = std::function<bool(const fs::path& from, const fs::path& to)>;

/// Files by their path inside the folder of results: the newest of all places.
using ResultFiles = std::map<fs::path, fs::path>;

/// Steps that write files of their own among the results have them in folders of this name.
constexpr const char* ownFiles = "files";

/// The folder of the step whose file it is; empty for results.
fs::path ownerOf(const fs::path& name)
{
    fs::path owner;
    for (const fs::path& part : name.parent_path()) {
        if (part == ownFiles)
            return owner;
        owner /= part;
    }
    return {};
}

void addFiles(const fs::path& folder, ResultFiles& files)
{
    std::error_code error;
    for (auto entry = fs::recursive_directory_iterator(folder, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code missing;
        const fs::path name = entry->path().lexically_relative(folder);
        const bool isResult = name.extension() == ".h5" && name.stem() != "contact-sheet";
        if (!entry->is_regular_file(missing) || (!isResult && ownerOf(name).empty()))
            continue;
        const auto known = files.find(name);
        if (known == files.end() ||
            fs::last_write_time(known->second, missing) < entry->last_write_time(missing))
            files[name] = entry->path();
    }
}

ResultFiles filesOf(const fs::path& projectFile)
{
    const ResultPlaces places = resultPlaces(projectFile);
    ResultFiles files;
    addFiles(places.written, files);
    for (const fs::path& place : places.others)
        addFiles(place, files);
    return files;
}

[[noreturn]] void failWriting(const fs::path& file, int error)
{
    throwSystemError(file, error, ErrorCode::WriteFailed);
}

void makeFolder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        failWriting(folder, error.value());
}

void move(const fs::path& from, const fs::path& to)
{
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
        failWriting(to, error.value());
}

/// A folder beside the one that results are given to; what is in it is gone unless it was moved.
class Staging
{
public:
    explicit Staging(fs::path target) : m_target(std::move(target)), m_folder(m_target)
    {
        static std::atomic<unsigned> counter{0};
        m_folder += ".giving-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    }
    ~Staging()
    {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
    Staging(const Staging&) = delete;
    Staging& operator=(const Staging&) = delete;

    const fs::path& folder() const { return m_folder; }

    void commit() const
    {
        std::error_code error;
        if (!fs::exists(m_folder, error))
            return;
        if (!fs::exists(m_target, error)) {
            move(m_folder, m_target);
            return;
        }
        ResultFiles files;
        addFiles(m_folder, files);
        for (const auto& [name, file] : files) {
            makeFolder((m_target / name).parent_path());
            move(file, m_target / name);
        }
    }

private:
    fs::path m_target;
    fs::path m_folder;
};

/// A path that leads to one of the results of a project: where it is among those of another.
std::optional<std::string> givenPath(const std::string& path, const fs::path& fromProject,
                                     const fs::path& toProject)
{
    const fs::path file = fs::absolute(resolvePath(path, fromProject.parent_path())).lexically_normal();
    const ResultPlaces places = resultPlaces(fromProject);
    std::vector<fs::path> folders = places.others;
    folders.push_back(places.written);
    for (const fs::path& folder : folders) {
        const fs::path name = file.lexically_relative(fs::absolute(folder).lexically_normal());
        if (!name.empty() && *name.begin() != "..")
            return storedPath(fs::absolute(cacheFolder(toProject) / name),
                              fs::absolute(toProject).parent_path());
    }
    return std::nullopt;
}

/// A result names its own files where these are now.
void renameFilesOf(const fs::path& result, const fs::path& fromProject, const fs::path& toProject)
{
    std::vector<WrittenFile> files = readWrittenFiles(result);
    bool isOther = false;
    for (WrittenFile& written : files) {
        if (const auto path = givenPath(written.path, fromProject, toProject)) {
            written.path = *path;
            isOther = true;
        }
    }
    if (!isOther)
        return;
    Result content = readResultFile(result);
    content.files = std::move(files);
    writeResultFile(result, readResultHeader(result), content);
}

void renameOwnFiles(const ResultFiles& given, const fs::path& fromProject, const fs::path& toProject,
                    const fs::path& folder)
{
    std::set<fs::path> owners;
    for (const auto& [name, file] : given)
        owners.insert(ownerOf(name));
    for (const auto& [name, file] : given) {
        if (name.parent_path().empty() || !owners.contains(name.parent_path()) || !ownerOf(name).empty())
            continue;
        try {
            renameFilesOf(folder / name, fromProject, toProject);
        } catch (const Error& error) {
            if (error.code() != ErrorCode::ResultDamaged) // it is computed anew
                throw;
        }
    }
}

bool give(const fs::path& fromProject, const fs::path& toProject, const Give& giveFile,
          const Progress& progress)
{
    const fs::path target = cacheFolder(toProject);
    if (target == cacheFolder(fromProject))
        return true;
    const ResultFiles files = filesOf(fromProject);
    const Staging staging(target);
    std::int64_t done = 0;
    for (const auto& [name, file] : files) {
        progress.report(done++, static_cast<std::int64_t>(files.size()));
        const fs::path to = staging.folder() / name;
        makeFolder(to.parent_path());
        std::error_code error;
        if (!giveFile(file, to) && fs::exists(file, error))
            return false;
    }
    renameOwnFiles(files, fromProject, toProject, staging.folder());
    writeUnstoredResults(fromProject, staging.folder());
    staging.commit();
    progress.report(1);
    return true;
}

/// Blocks of a file that two files share until one of them changes.
bool cloneFile(const fs::path& from, const fs::path& to)
{
    const int source = ::open(from.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (source < 0)
        return false;
    constexpr int mode = 0644;
    const int target = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    const bool isCloned = target >= 0 && ::ioctl(target, FICLONE, source) == 0;
    if (target >= 0)
        ::close(target);
    ::close(source);
    if (!isCloned && target >= 0)
        ::unlink(to.c_str());
    return isCloned;
}

bool linkFile(const fs::path& from, const fs::path& to)
{
    return cloneFile(from, to) || ::link(from.c_str(), to.c_str()) == 0;
}

} // namespace

bool linkResults(const fs::path& fromProject, const fs::path& toProject)
{
    return give(fromProject, toProject, linkFile, {});
}

void copyResults(const fs::path& fromProject, const fs::path& toProject, const Progress& progress)
{
    give(
        fromProject, toProject,
        [&progress](const fs::path& from, const fs::path& to) {
            progress.report(0);
            std::error_code error;
            fs::copy_file(from, to, error);
            if (error && fs::exists(from))
                failWriting(to, error.value());
            return true;
        },
        progress);
}

} // namespace quadrille
