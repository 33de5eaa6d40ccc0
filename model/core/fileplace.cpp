// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/fileplace.h"

#include <algorithm>
#include <sys/stat.h>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// As many links in a row as the system follows itself.
constexpr int linksAtMost = 40;

fs::path resolved(const fs::path& path, int links)
{
    fs::path place = path.root_path();
    for (const fs::path& part : path.relative_path()) {
        if (part.empty() || part == ".")
            continue;
        if (part == "..") {
            place = place.parent_path();
            continue;
        }
        fs::path next = place / part;
        std::error_code error;
        const fs::path target = fs::read_symlink(next, error);
        if (!error && links > 0)
            next = resolved(target.is_absolute() ? target : place / target, links - 1);
        place = std::move(next);
    }
    return place;
}

} // namespace

fs::path resolvedFolder(const fs::path& folder)
{
    return resolved(fs::absolute(folder.empty() ? fs::path(".") : folder), linksAtMost);
}

fs::path resolvedPlace(const fs::path& file)
{
    const fs::path absolute = fs::absolute(file);
    const fs::path name = absolute.filename();
    if (name.empty() || name == "." || name == "..")
        return resolvedFolder(absolute);
    return resolvedFolder(absolute.parent_path()) / name;
}

bool liesIn(const fs::path& place, const fs::path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), place.begin(), place.end()).first == folder.end();
}

std::optional<FileIdentity> identityOf(const fs::path& path)
{
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0)
        return std::nullopt;
    return FileIdentity{status.st_dev, status.st_ino};
}

} // namespace quadrille
