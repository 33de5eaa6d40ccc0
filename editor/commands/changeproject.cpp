// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/changeproject.h"

#include "model/project/fields/entrymemory.h"

namespace quadrille {

ChangeProject::ChangeProject(ProjectDocument& document, const QString& text, Project after,
                             std::optional<std::pair<EntryRef, QString>> renamed)
    : ProjectCommand(document, text)
    , m_before(document.project())
    , m_after(std::move(after))
    , m_renamed(std::move(renamed))
{
}

void ChangeProject::redo()
{
    std::vector<ChangeEvent> events;
    if (m_renamed)
        events = {ChangeEvent::renamed(m_renamed->first.section, m_renamed->second, m_renamed->first.name)};
    show(m_after, std::move(events));
}

void ChangeProject::undo()
{
    if (isExpired()) {
        setObsolete(true);
        return;
    }
    std::vector<ChangeEvent> events;
    if (m_renamed)
        events = {ChangeEvent::renamed(m_renamed->first.section, m_renamed->first.name, m_renamed->second)};
    show(m_before, std::move(events));
}

std::size_t ChangeProject::bytes() const
{
    return sizeof(*this) + memoryOf(m_before) + memoryOf(m_after);
}

void ChangeProject::show(const Project& project, std::vector<ChangeEvent> events)
{
    const auto tell = [&](Section section, bool isSame) {
        if (!isSame && !(m_renamed && m_renamed->first.section == section))
            events.push_back(ChangeEvent::list(section));
    };
    sectionlists::forEachNamed(m_before,
                               [&]<typename Entry>(Section section, const std::vector<Entry>& entries) {
                                   tell(section, entries == entriesOf<Entry>(m_after));
                               });
    tell(Section::Graphs, m_before.graphs == m_after.graphs);
    tell(Section::BodyParts, m_before.bodyParts == m_after.bodyParts);
    tell(Section::Evaluations, m_before.evaluations == m_after.evaluations);
    tell(Section::Project, m_before.settings == m_after.settings && m_before.unknown == m_after.unknown);
    apply([&](Project& shown) { shown = project; }, events);
}

} // namespace quadrille
