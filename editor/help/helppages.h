// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>
#include <QString>

namespace quadrille {

/// A heading of a page with what stands below it, up to the next.
struct HelpSection
{
    QString page;    ///< file name without ending
    int heading = 0; ///< which one of the page, from 0
    QString title;   ///< of the page
    QString name;    ///< of the heading
    QString text;    ///< without marks
};

/// A place where what was looked for stands.
struct HelpHit
{
    HelpSection section;
    QString excerpt; ///< one line around the first place
};

/// Names of all pages, without ending. In alphabetical order.
QStringList helpPages();
/// File of a page in a language, English where it has no translation; empty when there is no such page.
QString helpPageFile(const QString& page, const QString& language);
/// The sections of a page, in order. The marks of Markdown are taken out of texts. None where there is no
/// such page. Reads the page each time.
QList<HelpSection> helpSections(const QString& page, const QString& language);
/// Sections in which all words of a text stand (their beginnings suffice), best first: those that have them
/// in their headings. Case and accents do not matter. An empty text has none. Reads all pages.
QList<HelpHit> searchHelp(const QString& words, const QString& language);

} // namespace quadrille
