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

} // namespace

StagedFiles::StagedFiles(const fs::path& folder) : m_folder(folder.empty() ? fs::path(".") : folder)
{
    static std::atomic<unsigned> counter{0};
    std::error_code error;
    for (fs::path made = fs::absolute(m_folder, error); !fs::exists(made, error) && made.has_relative_path();
         made = made.parent_path())
        m_madeFolder = made;
    m_staging = m_folder / (".writing-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    makeFolder(m_staging);
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
    for (const std::string& name : m_names) {
        makeFolder((m_folder / name).parent_path());
        std::error_code error;
        fs::rename(m_staging / name, m_folder / name, error);
        if (error)
            throwSystemError(m_folder / name, error.value(), ErrorCode::WriteFailed);
        m_isDone = true; // what is in place stays
        paths.push_back(m_folder / name);
    }
    return paths;
}

std::string numberedName(const fs::path& out, std::int64_t number, std::int64_t count)
{
    const std::size_t digits =
        std::max<std::size_t>(4, std::to_string(std::max<std::int64_t>(count - 1, 0)).size());
    std::string text = std::to_string(number);
    text.insert(0, digits - std::min(digits, text.size()), '0');
    return out.stem().string() + "_" + text + out.extension().string();
}

} // namespace quadrille
