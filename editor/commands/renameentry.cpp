// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/renameentry.h"

#include "editor/commands/entryaccess.h"

namespace quadrille {

RenameEntry::RenameEntry(ProjectDocument& document, const QString& text, const EntryRef& entry, QString after)
    : ProjectCommand(document, text)
    , m_section(entry.section)
    , m_before(entry.name)
    , m_after(std::move(after))
{
    const Project& project = document.project();
    const std::string name = m_before.toStdString();
    if (m_section == Section::Characters) {
        for (std::size_t i = 0; i < project.sequences.size(); ++i) {
            if (project.sequences[i].character == name)
                m_references.push_back(i);
        }
    } else if (m_section == Section::Sequences) {
        for (std::size_t i = 0; i < project.exports.size(); ++i) {
            if (project.exports[i].what == "sequences/" + name)
                m_references.push_back(i);
        }
    }
}

void RenameEntry::undo()
{
    if (isExpired())
        setObsolete(true);
    else
        rename(m_after, m_before);
}

void RenameEntry::rename(const QString& from, const QString& to)
{
    const std::string name = to.toStdString();
    apply(
        [&](Project& project) {
            switch (m_section) {
            case Section::Project:
            case Section::Graphs:
                break;
            case Section::Characters:
                entryOf<CharacterEntry>(project, from).name = name;
                for (const std::size_t i : m_references)
                    project.sequences[i].character = name;
                break;
            case Section::Sequences:
                entryOf<SequenceEntry>(project, from).name = name;
                for (const std::size_t i : m_references)
                    project.exports[i].what = "sequences/" + name;
                break;
            case Section::Animations:
                entryOf<AnimationEntry>(project, from).name = name;
                break;
            case Section::Exports:
                entryOf<ExportEntry>(project, from).name = name;
                break;
            }
        },
        {ChangeEvent::renamed(m_section, from, to)});
}

} // namespace quadrille
