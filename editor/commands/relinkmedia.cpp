// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/relinkmedia.h"

#include "editor/commands/entryaccess.h"

#include <algorithm>

namespace quadrille {

RelinkMedia::RelinkMedia(ProjectDocument& document, const QString& text,
                         const std::vector<std::pair<std::string, std::string>>& newPaths)
    : ProjectCommand(document, text)
    , m_before{document.project().characters, document.project().sequences, document.project().animations}
    , m_after(m_before)
{
    const auto replace = [&](std::string& path) {
        const auto found = std::ranges::find(newPaths, path, &std::pair<std::string, std::string>::first);
        if (found != newPaths.end())
            path = found->second;
    };
    for (CharacterEntry& character : m_after.characters) {
        replace(character.mesh);
        std::ranges::for_each(character.texture.paths, replace);
    }
    for (SequenceEntry& sequence : m_after.sequences) {
        replace(sequence.source);
        replace(sequence.jointAngles);
        std::ranges::for_each(sequence.texture.paths, replace);
    }
    for (AnimationEntry& animation : m_after.animations) {
        if (animation.audio)
            replace(animation.audio->file);
    }
}

void RelinkMedia::undo()
{
    if (isExpired())
        setObsolete(true);
    else
        show(m_before);
}

std::size_t RelinkMedia::bytes() const
{
    std::size_t sum = sizeof(*this);
    for (const Entries* entries : {&m_before, &m_after}) {
        for (const CharacterEntry& character : entries->characters)
            sum += memoryOf(character);
        for (const SequenceEntry& sequence : entries->sequences)
            sum += memoryOf(sequence);
        for (const AnimationEntry& animation : entries->animations)
            sum += memoryOf(animation);
    }
    return sum;
}

void RelinkMedia::show(const Entries& entries)
{
    apply(
        [&](Project& project) {
            project.characters = entries.characters;
            project.sequences = entries.sequences;
            project.animations = entries.animations;
        },
        {ChangeEvent::list(Section::Characters), ChangeEvent::list(Section::Sequences),
         ChangeEvent::list(Section::Animations)});
}

} // namespace quadrille
