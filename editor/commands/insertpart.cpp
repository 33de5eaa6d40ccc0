// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/insertpart.h"

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
    return std::apply([](const auto&... placed) { return (memoryOfPlaced(placed) + ...); }, entries);
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
    const auto forEachKind = [this](const auto& visit) {
        std::apply([&](const auto&... placed) { (visit(placed), ...); }, m_part.entries);
    };
    std::vector<ChangeEvent> events;
    forEachKind([&]<typename Entry>(const PlacedEntries<Entry>& placed) {
        if (!placed.empty())
            events.push_back(ChangeEvent::list(sectionOf<Entry>()));
    });
    if (m_part.fps)
        events.push_back(ChangeEvent::value(Section::Project, {}));
    apply(
        [&](Project& project) {
            forEachKind([&](const auto& placed) { exchange(project, placed, insert); });
            if (m_part.fps)
                std::swap(project.settings.fps, *m_part.fps);
        },
        events);
}

} // namespace quadrille
