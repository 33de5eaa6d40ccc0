// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectcommand.h"

#include <optional>

namespace quadrille {

/// An edit that reaches through several sections: an entry that gets another name or goes, with all that
/// refers to it. Holds the project before and after it.
class ChangeProject : public ProjectCommand
{
public:
    /// \param after the project with the edit.
    /// \param renamed the entry that has another name in it, by its new name, and the one it had.
    ChangeProject(ProjectDocument& document, const QString& text, Project after,
                  std::optional<std::pair<EntryRef, QString>> renamed = {});

    void redo() override;
    void undo() override;
    std::size_t bytes() const override;
    bool changesNothing() const override { return m_before == m_after; }

protected:
    void release() override { m_before = m_after = Project(); }

private:
    void show(const Project& project, std::vector<ChangeEvent> events);

    Project m_before;
    Project m_after;
    std::optional<std::pair<EntryRef, QString>> m_renamed;
};

} // namespace quadrille
