// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/relinkmedia.h"

#include "model/project/fields/entrymemory.h"
#include "model/project/fields/entrypaths.h"

#include <algorithm>

namespace quadrille {

RelinkMedia::RelinkMedia(ProjectDocument& document, const QString& text,
                         const std::vector<std::pair<std::string, std::string>>& newPaths)
    : ProjectCommand(document, text)
    , m_before{document.project().characters, document.project().sequences, document.project().animations}
{
    Project project = document.project();
    forEachPath(project, [&](const StoredPath& stored) {
        const auto found =
            std::ranges::find(newPaths, stored.path, &std::pair<std::string, std::string>::first);
        if (found != newPaths.end() && !stored.isOutput)
            stored.path = found->second;
    });
    m_after = {std::move(project.characters), std::move(project.sequences), std::move(project.animations)};
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
    for (const Entries* entries : {&m_before, &m_after})
        sum += memoryOf(entries->characters) + memoryOf(entries->sequences) + memoryOf(entries->animations);
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
