// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QUndoCommand>
#include <vector>

namespace quadrille {

/// One edit of a project, named as the user would name it. Commands find what they change by name, never by
/// pointer. They are made of values, so that they can be run, taken back and run again at any time while the
/// history has them.
class ProjectCommand : public QUndoCommand
{
public:
    ProjectCommand(ProjectDocument& document, const QString& text) : m_document(document) { setText(text); }

    /// Memory that the command holds.
    virtual std::size_t bytes() const = 0;
    /// Then it is not pushed, unless it ends a drag.
    virtual bool changesNothing() const { return false; }
    /// A drag is still going on and the next step merges into this command.
    virtual bool isOpen() const { return false; }

    /// Gives its memory back; from then on it cannot be undone.
    void expire()
    {
        m_expired = true;
        release();
    }
    /// Its `undo` then changes nothing, and drops it.
    bool isExpired() const { return m_expired; }

protected:
    /// Lets go of all values.
    virtual void release() = 0;
    /// Edits the project, then tells the events, renames first.
    void apply(const std::function<void(Project&)>& edit, const std::vector<ChangeEvent>& events) const
    {
        m_document.apply(edit, events);
    }

private:
    ProjectDocument& m_document;
    bool m_expired = false;
};

} // namespace quadrille
