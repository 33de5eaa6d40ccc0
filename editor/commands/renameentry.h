// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/projectcommand.h"

#include <vector>

namespace quadrille {

/// Gives a character, sequence or export another name, and everything that refers to it the new one.
class RenameEntry : public ProjectCommand
{
public:
    /// \pre The entry exists; no other of its section has the name `after`.
    RenameEntry(ProjectDocument& document, const QString& text, const EntryRef& entry, QString after);

    void redo() override { rename(m_before, m_after); }
    void undo() override;
    std::size_t bytes() const override { return sizeof(*this) + m_references.size() * sizeof(std::size_t); }
    bool changesNothing() const override { return m_before == m_after; }

protected:
    void release() override { m_references = {}; }

private:
    void rename(const QString& from, const QString& to);

    Section m_section;
    QString m_before;
    QString m_after;
    /// Indices of the sequences (for a character) or exports (for a sequence) that refer to the entry.
    std::vector<std::size_t> m_references;
};

} // namespace quadrille
