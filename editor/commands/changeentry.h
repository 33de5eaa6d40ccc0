// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectcommand.h"
#include "model/project/fields/entrymemory.h"

#include <utility>

namespace quadrille {

/// Whether an edit is complete, or a step of a drag that the next one replaces. A drag ends by a Final one of
/// the same property.
enum class EditPhase
{
    Final,
    Dragging,
};

/// Exchanges the values of one entry, or of a section that is one value, for others; an entry keeps its name.
/// Steps of a drag merge into one command; a drag that comes back to where it began drops itself.
template <typename Entry>
class ChangeEntry : public ProjectCommand
{
public:
    /// \param property tells which value of the entry is edited; only steps of the same one merge.
    /// \param after the entry with its new values.
    /// \pre The entry exists.
    ChangeEntry(ProjectDocument& document, const QString& text, QString name, QString property, Entry after,
                EditPhase phase = EditPhase::Final)
        : ProjectCommand(document, text)
        , m_name(std::move(name))
        , m_property(std::move(property))
        , m_before(entryOf<Entry>(document.project(), m_name))
        , m_after(std::move(after))
        , m_open(phase == EditPhase::Dragging)
    {
    }

    void redo() override
    {
        set(m_after);
        setObsolete(changesNothing());
    }
    void undo() override
    {
        if (isExpired())
            setObsolete(true);
        else
            set(m_before);
    }
    int id() const override { return static_cast<int>(sectionOf<Entry>()); }
    bool mergeWith(const QUndoCommand* other) override
    {
        const auto* next = static_cast<const ChangeEntry*>(other);
        if (!m_open || next->m_name != m_name || next->m_property != m_property)
            return false;
        m_after = next->m_after;
        m_open = next->m_open;
        if (!m_open && m_after == m_before)
            setObsolete(true);
        return true;
    }
    std::size_t bytes() const override { return sizeof(*this) + memoryOf(m_before) + memoryOf(m_after); }
    bool changesNothing() const override { return m_before == m_after; }
    bool isOpen() const override { return m_open; }

protected:
    void release() override { m_before = m_after = Entry{}; }

private:
    void set(const Entry& value)
    {
        apply([&](Project& project) { entryOf<Entry>(project, m_name) = value; },
              {ChangeEvent::value(sectionOf<Entry>(), m_name)});
    }

    QString m_name;
    QString m_property;
    Entry m_before;
    Entry m_after;
    bool m_open;
};

/// Edits a copy of an entry and pushes the change.
/// \param edit takes Entry&. Nothing happens when it changes nothing. \pre The entry exists.
template <typename Entry, typename Edit>
void editEntry(ProjectDocument& document, const QString& text, const QString& name, const QString& property,
               const Edit& edit, EditPhase phase = EditPhase::Final)
{
    Entry after = entryOf<Entry>(document.project(), name);
    edit(after);
    document.push(
        std::make_unique<ChangeEntry<Entry>>(document, text, name, property, std::move(after), phase));
}

} // namespace quadrille
