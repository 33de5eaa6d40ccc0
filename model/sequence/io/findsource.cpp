// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/sequence/io/files/refused.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/registry.h"

#include <cerrno>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Extensions of formats with one file per frame, and of those that are refused as a series.
std::vector<std::string> seriesExtensions()
{
    std::vector<std::string> extensions = refusedSeriesExtensions();
    for (const auto& importer : importers()) {
        const auto& format = importer->format();
        if (format.onePerFrame)
            extensions.insert(extensions.end(), format.extensions.begin(), format.extensions.end());
    }
    return extensions;
}

SourceFiles findInFolder(const fs::path& folder)
{
    auto content = scanFolder(folder, seriesExtensions());
    // Single meshes beside one series (a template, a rest pose) do not make it unclear.
    if (content.series.size() == 1)
        content.singles.clear();
    return onlySeries(std::move(content), folder);
}

} // namespace

SourceFiles findSource(const fs::path& path)
{
    std::error_code error;
    const auto status = fs::status(path, error);
    if (fs::is_directory(status))
        return findInFolder(path);
    if (fs::exists(status))
        return {.path = path, .files = {path}, .stem = path.stem().string()};
    if (isPattern(path))
        return findPattern(path);
    throwSystemError(path, error ? error.value() : ENOENT, ErrorCode::ReadFailed);
}

SourceFiles seriesAround(const fs::path& file)
{
    auto single = findSource(file);
    const std::vector<std::string> extension{lowerExtension(file)};
    for (auto& series : scanFolder(file.parent_path(), extension).series) {
        for (const auto& member : series.files) {
            if (member.filename() == file.filename())
                return std::move(series);
        }
    }
    return single;
}

} // namespace quadrille
