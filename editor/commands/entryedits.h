// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/commands/insertpart.h"
#include "editor/commands/projectedits.h"
#include "editor/documents/editcheck.h"

namespace quadrille {

// What edits of entries of all kinds have in common. Texts are what the history calls them, translated.

/// \param place  that it takes in its section, from 0. \return whether it was taken.
template <typename Entry>
bool insertEntry(ProjectDocument& document, const QString& text, std::size_t place, Entry entry)
{
    ProjectPart part;
    part.of<Entry>().emplace_back(place, std::move(entry));
    return wasTaken(document, std::make_unique<InsertPart>(document, text, std::move(part)));
}

/// Adds an entry behind the others. \param text  has “%1” for its name. \return the name that it got; empty
/// where it is refused.
template <typename Entry>
QString addEntry(ProjectDocument& document, const QString& text, Entry entry)
{
    QString name = freeName(document.project(), sectionOf<Entry>(), QString::fromStdString(entry.name));
    entry.name = name.toStdString();
    const std::size_t place = entriesOf<Entry>(document.project()).size();
    return insertEntry(document, text.arg(name), place, std::move(entry)) ? name : QString();
}

/// Adds a copy behind the original. \return the copy's name; empty where it is refused. \pre The original is
/// there.
template <typename Entry>
QString duplicateEntry(ProjectDocument& document, const QString& text, const QString& name)
{
    const auto& entries = entriesOf<Entry>(document.project());
    const auto original = std::ranges::find(entries, name.toStdString(), &Entry::name);
    assert(original != entries.end());
    const auto place = static_cast<std::size_t>(original - entries.begin()) + 1;
    Entry copy = *original;
    QString copyName = freeName(document.project(), sectionOf<Entry>(), name);
    copy.name = copyName.toStdString();
    return insertEntry(document, text, place, std::move(copy)) ? copyName : QString();
}

/// Exchanges the values of an entry; its name stays.
template <typename Entry>
void setEntry(ProjectDocument& document, const QString& name, const QString& text, const QString& property,
              Entry after, EditPhase phase)
{
    document.push(
        std::make_unique<ChangeEntry<Entry>>(document, text, name, property, std::move(after), phase));
}

/// Exchanges the one entry that a character has in a section of such entries, or adds it.
/// \param isIts  takes an entry: whether it is of the same character.
template <typename Entry, typename IsIts>
void setEntryOfCharacter(ProjectDocument& document, const QString& text, const QString& property,
                         const Entry& after, EditPhase phase, IsIts isIts)
{
    using Entries = std::vector<Entry>;
    Entries entries = entryOf<Entries>(document.project(), {});
    if (const auto found = std::ranges::find_if(entries, isIts); found != entries.end())
        *found = after;
    else
        entries.push_back(after);
    setEntry<Entries>(document, QString::fromStdString(after.character), text, property, std::move(entries),
                      phase);
}

} // namespace quadrille
