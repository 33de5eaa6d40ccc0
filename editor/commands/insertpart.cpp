// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/insertpart.h"

#include "editor/commands/entryaccess.h"
#include "model/project/fields/entrymemory.h"

namespace quadrille {

namespace {

template <typename Entry>
std::size_t memoryOfPlaced(const PlacedEntries<Entry>& entries)
{
    std::size_t sum = 0;
    for (const auto& [place, entry] : entries)
        sum += memoryOf(entry);
    return sum;
}

template <typename Entry>
void exchange(Project& project, const PlacedEntries<Entry>& part, bool insert)
{
    auto& all = entriesOf<Entry>(project);
    if (insert) {
        for (const auto& [place, entry] : part)
            all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), entry);
    } else {
        for (auto it = part.rbegin(); it != part.rend(); ++it)
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(it->first));
    }
}

} // namespace

std::size_t ProjectPart::bytes() const
{
    return memoryOfPlaced(characters) + memoryOfPlaced(sequences) + memoryOfPlaced(animations) +
           memoryOfPlaced(variations) + memoryOfPlaced(exports);
}

InsertPart::InsertPart(ProjectDocument& document, const QString& text, ProjectPart part)
    : ProjectCommand(document, text), m_part(std::move(part))
{
}

void InsertPart::undo()
{
    if (isExpired())
        setObsolete(true);
    else
        run(false);
}

void InsertPart::run(bool insert)
{
    std::vector<ChangeEvent> events;
    if (!m_part.characters.empty())
        events.push_back(ChangeEvent::list(Section::Characters));
    if (!m_part.sequences.empty())
        events.push_back(ChangeEvent::list(Section::Sequences));
    if (!m_part.animations.empty())
        events.push_back(ChangeEvent::list(Section::Animations));
    if (!m_part.variations.empty())
        events.push_back(ChangeEvent::list(Section::Variations));
    if (!m_part.exports.empty())
        events.push_back(ChangeEvent::list(Section::Exports));
    if (m_part.fps)
        events.push_back(ChangeEvent::value(Section::Project, {}));
    apply(
        [&](Project& project) {
            exchange(project, m_part.characters, insert);
            exchange(project, m_part.sequences, insert);
            exchange(project, m_part.animations, insert);
            exchange(project, m_part.variations, insert);
            exchange(project, m_part.exports, insert);
            if (m_part.fps)
                std::swap(project.settings.fps, *m_part.fps);
        },
        events);
}

} // namespace quadrille
