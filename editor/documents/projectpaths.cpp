// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectpaths.h"

#include "model/project/document/paths.h"
#include "model/project/fields/entrypaths.h"

namespace quadrille {

QString toQString(const std::filesystem::path& path)
{
    return QString::fromStdU16String(path.u16string());
}

std::filesystem::path toPath(const QString& text)
{
    return {text.toStdU16String()};
}

Project withAbsolutePaths(Project project, const std::filesystem::path& folder)
{
    forEachPath(project, [&](const StoredPath& stored) {
        if (!stored.path.empty())
            stored.path = (folder / stored.path).lexically_normal().generic_string();
    });
    return project;
}

Project withRelativePaths(Project project, const std::filesystem::path& folder)
{
    forEachPath(project, [&](const StoredPath& stored) {
        if (stored.path.empty())
            return;
        const auto relative =
            std::filesystem::path(stored.path).lexically_relative(folder.lexically_normal());
        const std::string text = relative.empty() ? stored.path : relative.generic_string();
        stored.path = clipOfSource(text) ? "./" + text : text;
    });
    return project;
}

} // namespace quadrille
