// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectcommand.h"

#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// Exchanges paths of media, wherever the project uses them.
class RelinkMedia : public ProjectCommand
{
public:
    /// \param newPaths old and new path of each medium.
    RelinkMedia(ProjectDocument& document, const QString& text,
                const std::vector<std::pair<std::string, std::string>>& newPaths);

    void redo() override { show(m_after); }
    void undo() override;
    std::size_t bytes() const override;
    bool changesNothing() const override { return m_before == m_after; }

protected:
    void release() override { m_before = m_after = {}; }

private:
    struct Entries
    {
        std::vector<CharacterEntry> characters;
        std::vector<SequenceEntry> sequences;
        std::vector<AnimationEntry> animations;
        bool operator==(const Entries&) const = default;
    };
    void show(const Entries& entries);

    Entries m_before;
    Entries m_after;
};

} // namespace quadrille
