// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/sections.h"

#include <QMetaType>
#include <QString>

namespace quadrille {

/// One entry of a project, by the name that makes it unique in its section; no name: the section itself.
struct EntryRef
{
    Section section = Section::Project;
    QString name;

    bool operator==(const EntryRef&) const = default;
};

/// What changed in a document; views pick what concerns them.
struct ChangeEvent
{
    enum class Kind
    {
        Reset,   ///< another project, or everything at once
        Entry,   ///< the values of one entry
        List,    ///< entries of a section came, went or moved
        Renamed, ///< an entry has another name; `before` is the old one
        File,    ///< path or modified state of the document
    };

    Kind kind = Kind::Reset;
    EntryRef entry;
    QString before;

    static ChangeEvent reset() { return {}; }
    static ChangeEvent file() { return {Kind::File, {}, {}}; }
    static ChangeEvent list(Section section) { return {Kind::List, {section, {}}, {}}; }
    static ChangeEvent value(Section section, QString name)
    {
        return {Kind::Entry, {section, std::move(name)}, {}};
    }
    static ChangeEvent renamed(Section section, QString before, QString after)
    {
        return {Kind::Renamed, {section, std::move(after)}, std::move(before)};
    }

    /// True for a reset and for every change of a section.
    bool touches(Section section) const
    {
        return kind == Kind::Reset || (kind != Kind::File && entry.section == section);
    }
};

} // namespace quadrille

Q_DECLARE_METATYPE(quadrille::ChangeEvent)
