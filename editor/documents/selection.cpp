// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/selection.h"

#include <algorithm>

namespace quadrille {

Selection::Selection(ProjectDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&document, &ProjectDocument::changed, this, &Selection::follow);
}

void Selection::select(const EntryRef& entry)
{
    if (entry.section == Section::Sequences && !entry.name.isEmpty()) {
        selectSequences({entry.name});
        return;
    }
    if (m_current == entry && m_sequences.isEmpty())
        return;
    m_current = entry;
    m_sequences.clear();
    emit changed();
}

void Selection::selectSequences(const QStringList& names, const QString& current)
{
    if (names.isEmpty()) {
        clear();
        return;
    }
    const EntryRef entry{Section::Sequences, names.contains(current) ? current : names.back()};
    if (m_current == entry && m_sequences == names)
        return;
    m_current = entry;
    m_sequences = names;
    m_shown = entry.name;
    emit changed();
}

bool Selection::exists(const EntryRef& entry) const
{
    if (entry.name.isEmpty())
        return true;
    switch (entry.section) {
    case Section::Project:
    case Section::Graphs:
        return true;
    case Section::Characters:
        return m_document.character(entry.name) != nullptr;
    case Section::Sequences:
        return m_document.sequence(entry.name) != nullptr;
    case Section::Animations:
        return m_document.animation(entry.name) != nullptr;
    case Section::Exports:
        return m_document.exportEntry(entry.name) != nullptr;
    }
    return false;
}

void Selection::showExisting()
{
    if (m_document.sequence(m_shown) != nullptr)
        return;
    const auto& all = m_document.project().sequences;
    m_shown = all.empty() ? QString() : QString::fromStdString(all.front().name);
}

void Selection::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Renamed) {
        if (m_current == EntryRef{event.entry.section, event.before})
            m_current.name = event.entry.name;
        if (event.entry.section == Section::Sequences) {
            std::ranges::replace(m_sequences, event.before, event.entry.name);
            if (m_shown == event.before)
                m_shown = event.entry.name;
        }
        emit changed();
    } else if (event.kind == ChangeEvent::Kind::List || event.kind == ChangeEvent::Kind::Reset) {
        const QString shownBefore = m_shown;
        const auto countBefore = m_sequences.size();
        m_sequences.removeIf([this](const QString& name) { return m_document.sequence(name) == nullptr; });
        showExisting();
        const bool currentIsThere = exists(m_current);
        if (!currentIsThere)
            m_current = m_sequences.isEmpty() ? EntryRef{} : EntryRef{Section::Sequences, m_sequences.back()};
        if (!currentIsThere || m_shown != shownBefore || m_sequences.size() != countBefore)
            emit changed();
    }
}

} // namespace quadrille
