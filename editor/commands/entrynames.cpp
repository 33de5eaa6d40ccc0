// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/entrynames.h"

#include "model/core/utf8.h"
#include "model/project/document/brokenentry.h"
#include "model/project/document/entryname.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct EntryTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ProjectEdits)
};

Error refusal(const QString& reason, const QString& remedy)
{
    return Error(ErrorCode::BadArgument,
                 {{}, {}, {{"reason", reason.toStdString()}, {"remedy", remedy.toStdString()}}});
}

/// What comes of a text where names take no slashes, control characters, …
QString usableName(const QString& text)
{
    QString name;
    for (const QChar letter : text)
        name += letter == QLatin1Char('/') || letter == QLatin1Char('\\') ||
                        letter.category() == QChar::Other_Control
                    ? QLatin1Char('-')
                    : letter;
    name = name.trimmed();
    std::string cut = name.toStdString();
    while (problemWithName(cut) && cut.size() > 1)
        cut = cutUtf8(cut, cut.size() - 1);
    return problemWithName(cut) ? QStringLiteral("unnamed") : QString::fromStdString(cut).trimmed();
}

} // namespace

bool isTaken(const Project& project, Section section, const QString& name)
{
    const SectionInfo* info = findSection(section);
    const bool isBroken = std::ranges::any_of(brokenEntries(project), [&](const BrokenEntry& entry) {
        return info != nullptr && entry.section == info->key && entry.name() == name.toStdString();
    });
    return isBroken || (info != nullptr && info->isRenamable && info->names(project).contains(name));
}

QString freeName(const Project& project, Section section, const QString& wanted)
{
    const QString usable = usableName(wanted);
    QString name = usable;
    for (int i = 2; isTaken(project, section, name); ++i) {
        QString head = usable;
        do {
            name = QStringLiteral("%1 %2").arg(head).arg(i);
            head.chop(1);
        } while (problemWithName(name.toStdString()) && !head.isEmpty());
    }
    return name;
}

std::optional<Error> problemWithText(const QString& name)
{
    const auto reason = problemWithName(name.trimmed().toStdString());
    if (!reason)
        return std::nullopt;
    return refusal(QString::fromStdString(*reason), {});
}

std::optional<Error> problemWithRename(const Project& project, const EntryRef& entry, const QString& name)
{
    const std::string text = name.trimmed().toStdString();
    if (auto problem = problemWithText(name))
        return problem;
    if (text != entry.name.toStdString() && isTaken(project, entry.section, name.trimmed()))
        return refusal(EntryTexts::tr("“%1” is taken").arg(name.trimmed()),
                       EntryTexts::tr("Choose another name."));
    return std::nullopt;
}

} // namespace quadrille
