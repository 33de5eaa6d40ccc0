// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/paths.h"

namespace quadrille {

namespace fs = std::filesystem;

std::string storedPath(const fs::path& file, const fs::path& folder)
{
    const auto absolute = fs::absolute(file).lexically_normal();
    auto relative = absolute.lexically_relative(fs::absolute(folder).lexically_normal());
    // Through a symbolic link, ".." leads elsewhere than the text says.
    if (!relative.empty() && *relative.begin() == "..") {
        std::error_code error;
        const auto proximate = fs::proximate(absolute, folder, error);
        if (!error)
            relative = proximate;
    }
    const std::string text = (relative.empty() ? absolute : relative).generic_string();
    return clipOfSource(text) ? "./" + text : text;
}

fs::path resolvePath(std::string_view stored, const fs::path& folder)
{
    if (stored.empty())
        return {};
    const fs::path path(stored);
    return path.is_absolute() ? path : folder / path;
}

fs::path projectFolder(const fs::path& projectFile)
{
    return fs::absolute(projectFile).parent_path();
}

std::optional<std::string> clipOfSource(std::string_view source)
{
    constexpr std::string_view prefix = "clip:";
    if (!source.starts_with(prefix))
        return std::nullopt;
    return std::string(source.substr(prefix.size()));
}

std::optional<std::string> nameOfClip(std::string_view clip, std::string_view section)
{
    if (!clip.starts_with(section) || !clip.substr(section.size()).starts_with('/'))
        return std::nullopt;
    return std::string(clip.substr(section.size() + 1));
}

} // namespace quadrille
