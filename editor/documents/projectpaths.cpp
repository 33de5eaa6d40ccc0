// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/projectpaths.h"

#include "model/project/paths.h"

#include <functional>

namespace quadrille {

namespace {

using Rewrite = std::function<std::string(const std::string&)>;

void rewriteTexture(TextureReference& texture, const Rewrite& rewrite)
{
    for (std::string& path : texture.paths)
        path = rewrite(path);
}

Project rewritten(Project project, const Rewrite& rewrite)
{
    for (CharacterEntry& character : project.characters) {
        character.mesh = rewrite(character.mesh);
        rewriteTexture(character.texture, rewrite);
    }
    for (SequenceEntry& sequence : project.sequences) {
        sequence.source = rewrite(sequence.source);
        sequence.jointAngles = rewrite(sequence.jointAngles);
        rewriteTexture(sequence.texture, rewrite);
    }
    for (AnimationEntry& animation : project.animations) {
        animation.post.symmetry = rewrite(animation.post.symmetry);
        if (animation.audio)
            animation.audio->file = rewrite(animation.audio->file);
    }
    for (ExportEntry& entry : project.exports)
        entry.path = rewrite(entry.path);
    return project;
}

bool isPath(const std::string& text)
{
    return !text.empty() && !text.starts_with("clip:");
}

} // namespace

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
    return rewritten(std::move(project), [&](const std::string& text) {
        return isPath(text) ? (folder / text).lexically_normal().generic_string() : text;
    });
}

Project withRelativePaths(Project project, const std::filesystem::path& folder)
{
    return rewritten(std::move(project), [&](const std::string& text) {
        if (!isPath(text))
            return text;
        const auto relative = std::filesystem::path(text).lexically_relative(folder.lexically_normal());
        const std::string stored = relative.empty() ? text : relative.generic_string();
        return clipOfSource(stored) ? "./" + stored : stored;
    });
}

} // namespace quadrille
