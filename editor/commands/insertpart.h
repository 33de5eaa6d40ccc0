// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectcommand.h"

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille {

/// Entries together with the places they take in their section, ascending.
template <typename Entry>
using PlacedEntries = std::vector<std::pair<std::size_t, Entry>>;

/// Entries that come and go together: a sequence with its new character.
struct ProjectPart
{
    template <typename Lists>
    struct Of;
    template <typename... Entries>
    struct Of<std::tuple<sectionlists::Place<std::vector<Entries>>...>>
    {
        using Type = std::tuple<PlacedEntries<Entries>...>;
    };
    /// Of each kind that has names.
    Of<std::remove_const_t<decltype(sectionlists::named)>>::Type entries;
    /// The project's rate while the part is in it, where that is another one; the first sequences bring
    /// theirs.
    std::optional<double> fps;

    template <typename Entry>
    PlacedEntries<Entry>& of()
    {
        return std::get<PlacedEntries<Entry>>(entries);
    }
    /// Whether there is no entry; a rate alone does not count.
    bool isEmpty() const
    {
        return std::apply([](const auto&... placed) { return (placed.empty() && ...); }, entries);
    }
    /// What its entries take in memory.
    std::size_t bytes() const;
};

/// Puts a part into the project; undoing takes it out again.
class InsertPart : public ProjectCommand
{
public:
    InsertPart(ProjectDocument& document, const QString& text, ProjectPart part);

    void redo() override { run(true); }
    void undo() override;
    std::size_t bytes() const override { return sizeof(*this) + m_part.bytes(); }
    bool changesNothing() const override { return m_part.isEmpty(); }

protected:
    void release() override { m_part = {}; }

private:
    void run(bool insert);

    ProjectPart m_part;
};

} // namespace quadrille
