// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/stagedfiles.h"

#include "model/core/file.h"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <unistd.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

void makeFolder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throwSystemError(folder, error.value(), ErrorCode::WriteFailed);
}

/// A hidden folder that nobody has made before: what lies ready under its name is not written through.
fs::path makeStaging(const fs::path& folder)
{
    static std::atomic<unsigned> counter{0};
    for (;;) {
        fs::path staging =
            folder / (".writing-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
        std::error_code error;
        if (fs::create_directory(staging, error))
            return staging;
        if (error && error != std::errc::file_exists && error != std::errc::not_a_directory)
            throwSystemError(folder, error.value(), ErrorCode::WriteFailed);
    }
}

} // namespace

StagedFiles::StagedFiles(const fs::path& folder, WriteGuard* guard)
    : m_folder(folder.empty() ? fs::path(".") : folder), m_guard(guard)
{
    if (m_guard != nullptr)
        m_guard->checkFolder(m_folder);
    std::error_code error;
    for (fs::path made = fs::absolute(m_folder, error); !fs::exists(made, error) && made.has_relative_path();
         made = made.parent_path())
        m_madeFolder = made;
    makeFolder(m_folder);
    m_staging = makeStaging(m_folder);
}

StagedFiles::~StagedFiles()
{
    std::error_code ignored;
    fs::remove_all(m_staging, ignored);
    if (!m_isDone && !m_madeFolder.empty())
        fs::remove_all(m_madeFolder, ignored);
}

fs::path StagedFiles::add(const std::string& name)
{
    const std::scoped_lock lock(m_mutex);
    m_names.push_back(name);
    fs::path path = m_staging / name;
    makeFolder(path.parent_path());
    return path;
}

std::vector<fs::path> StagedFiles::commit()
{
    std::sort(m_names.begin(), m_names.end());
    std::vector<fs::path> paths;
    std::vector<WriteGuard::Move> moves;
    for (const std::string& name : m_names) {
        paths.push_back(m_folder / name);
        moves.push_back({m_staging / name, m_folder / name});
    }
    if (m_guard != nullptr) {
        m_guard->put(moves);
        m_isDone = true;
        return paths;
    }
    for (const WriteGuard::Move& move : moves) {
        makeFolder(move.to.parent_path());
        std::error_code error;
        fs::rename(move.from, move.to, error);
        if (error)
            throwSystemError(move.to, error.value(), ErrorCode::WriteFailed);
        m_isDone = true; // what is in place stays
    }
    return paths;
}

void writeGuarded(const fs::path& path, const std::function<void(const fs::path&)>& write, WriteGuard* guard)
{
    if (guard != nullptr)
        guard->checkPlace(path);
    StagedFiles files(path.parent_path(), guard);
    write(files.add(path.filename().string()));
    files.commit();
}

void writeGuarded(const fs::path& path, std::string_view content, WriteGuard* guard)
{
    writeGuarded(
        path, [content](const fs::path& temporary) { writeAtomically(temporary, content); }, guard);
}

} // namespace quadrille
