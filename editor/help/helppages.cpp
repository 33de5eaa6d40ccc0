// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/help/helppages.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <algorithm>

namespace quadrille {

namespace {

constexpr qsizetype excerptLength = 110;

QString englishFolder()
{
    return QStringLiteral(":/help/en");
}

/// Lower case without accents, as long as the text itself, so that places in one are places in the other.
QString folded(const QString& text)
{
    QString plain;
    plain.reserve(text.size());
    for (const QChar sign : text) {
        const QString parts = sign.decomposition();
        plain += (parts.isEmpty() ? sign : parts.front()).toLower();
    }
    return plain;
}

/// What a reader sees of a line of Markdown.
QString withoutMarks(QString line)
{
    static const QRegularExpression picture(QStringLiteral(R"(!\[[^\]]*\]\([^)]*\))"));
    static const QRegularExpression link(QStringLiteral(R"(\[([^\]]*)\]\([^)]*\))"));
    static const QRegularExpression rule(QStringLiteral(R"(^\s*\|?[\s|:-]+\|?\s*$)"));
    static const QRegularExpression list(QStringLiteral(R"(^\s*([-*]|\d+\.)\s+)"));
    static const QRegularExpression marks(QStringLiteral("[*`|\\\\]+"));
    if (rule.match(line).hasMatch())
        return {};
    line.remove(picture);
    line.replace(link, QStringLiteral("\\1"));
    line.remove(list);
    line.replace(marks, QStringLiteral(" "));
    return line.simplified();
}

/// Where a word begins in a text; −1 when none does.
qsizetype wordIn(const QString& text, const QString& word)
{
    for (qsizetype at = text.indexOf(word); at >= 0; at = text.indexOf(word, at + 1)) {
        if (at == 0 || !text.at(at - 1).isLetterOrNumber())
            return at;
    }
    return -1;
}

/// A line around a place, cut between words.
QString excerptOf(const QString& text, qsizetype place)
{
    qsizetype from = std::max<qsizetype>(0, place - excerptLength / 3);
    while (from > 0 && !text.at(from - 1).isSpace())
        --from;
    qsizetype to = std::min(text.size(), from + excerptLength);
    while (to < text.size() && !text.at(to).isSpace())
        ++to;
    return (from > 0 ? QStringLiteral("… ") : QString()) + text.mid(from, to - from) +
           (to < text.size() ? QStringLiteral(" …") : QString());
}

struct Found
{
    int rank = 0; ///< 0: not all words are there
    qsizetype place = 0;
};

Found findWords(const HelpSection& section, const QStringList& words)
{
    const QString title = folded(section.title);
    const QString name = folded(section.name);
    const QString text = folded(section.text);
    Found found{1, text.size()};
    for (const QString& word : words) {
        const qsizetype place = wordIn(text, word);
        const bool isInName = wordIn(name, word) >= 0;
        const bool isInTitle = wordIn(title, word) >= 0;
        if (place < 0 && !isInName && !isInTitle)
            return {};
        found.rank += isInName ? 4 : isInTitle ? 2 : 0;
        if (place >= 0)
            found.place = std::min(found.place, place);
    }
    if (found.place == text.size())
        found.place = 0;
    return found;
}

} // namespace

QStringList helpPages()
{
    QStringList pages;
    for (const QFileInfo& file : QDir(englishFolder()).entryInfoList({QStringLiteral("*.md")}))
        pages += file.completeBaseName();
    return pages;
}

QString helpPageFile(const QString& page, const QString& language)
{
    for (const QString& folder : {QStringLiteral(":/help/") + language, englishFolder()}) {
        QString file = QStringLiteral("%1/%2.md").arg(folder, page);
        if (QFile::exists(file))
            return file;
    }
    return {};
}

QList<HelpSection> helpSections(const QString& page, const QString& language)
{
    QFile file(helpPageFile(page, language));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    static const QRegularExpression heading(QStringLiteral("^#+\\s+(.*)$"));
    QList<HelpSection> sections;
    bool isCode = false;
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1String("```")))
            isCode = !isCode;
        const auto match = heading.match(line);
        if (match.hasMatch() && !isCode) {
            const QString name = withoutMarks(match.captured(1));
            const QString title = sections.isEmpty() ? name : sections.front().title;
            sections.push_back({page, static_cast<int>(sections.size()), title, name, {}});
        } else if (!sections.isEmpty()) {
            const QString text = isCode ? line.simplified() : withoutMarks(line);
            QString& all = sections.back().text;
            if (!text.isEmpty())
                all += all.isEmpty() ? text : QLatin1Char(' ') + text;
        }
    }
    return sections;
}

QList<HelpHit> searchHelp(const QString& words, const QString& language)
{
    static const QRegularExpression spaces(QStringLiteral("\\s+"));
    const QStringList wanted = folded(words).split(spaces, Qt::SkipEmptyParts);
    if (wanted.isEmpty())
        return {};
    std::vector<std::pair<int, HelpHit>> ranked;
    for (const QString& page : helpPages()) {
        for (const HelpSection& section : helpSections(page, language)) {
            const Found found = findWords(section, wanted);
            if (found.rank > 0)
                ranked.push_back({found.rank, {section, excerptOf(section.text, found.place)}});
        }
    }
    std::ranges::stable_sort(ranked, std::greater{}, [](const auto& each) { return each.first; });
    QList<HelpHit> hits;
    for (auto& [rank, hit] : ranked)
        hits.push_back(std::move(hit));
    return hits;
}

} // namespace quadrille
