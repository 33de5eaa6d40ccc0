// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/exportplan.h"

#include "editor/documents/projectpaths.h"
#include "editor/fields/clipchoice.h"
#include "model/core/seriesname.h"
#include "model/project/exports/exportentry.h"
#include "model/sequence/io/playerformat.h"

#include <QDir>
#include <filesystem>

namespace quadrille {

namespace {

/// A name that every file system takes.
QString fileNameOf(QString name)
{
    for (const QChar c : QStringLiteral("/\\:*?\"<>|"))
        name.replace(c, QLatin1Char('_'));
    return name.replace(QLatin1Char(' '), QLatin1Char('_'));
}

std::string nameOf(const QString& clip, const FormatInfo& format)
{
    return (nameOfClip(clip) + QLatin1Char(' ') +
            QString::fromStdString(format.extensions.front().substr(1)).toUpper())
        .toStdString();
}

} // namespace

const FormatInfo& ExportPlan::format() const
{
    return exporterOf(entry).format();
}

bool ExportPlan::isPlayer() const
{
    return format().id == playerFormat;
}

bool ExportPlan::isPicture() const
{
    return format().id == "png" || format().id == "mp4";
}

std::vector<ExportEntry> ExportPlan::entries() const
{
    std::vector<ExportEntry> result;
    const std::filesystem::path path = entry.path;
    for (const QString& clip : clips) {
        ExportEntry each = entry;
        each.what = clip.toStdString();
        if (clips.size() > 1) {
            each.name = nameOf(clip, format());
            each.path = (path.parent_path() /
                         (fileNameOf(nameOfClip(clip)).toStdString() + path.extension().string()))
                            .string();
            each.range.reset();
        }
        result.push_back(std::move(each));
    }
    return result;
}

QString ExportPlan::filesText(const ExportEntry& each, std::int64_t frames) const
{
    const std::filesystem::path path = each.path;
    if (!format().onePerFrame)
        return toQString(path.filename());
    QString first = QString::fromStdString(numberedName(path, 0, frames));
    if (frames == 1)
        return first;
    return first + QStringLiteral(" … ") + QString::fromStdString(numberedName(path, frames - 1, frames));
}

ExportPlan planExport(const QStringList& clips, const std::string& format, const QString& folder)
{
    ExportPlan plan;
    plan.clips = clips;
    plan.entry.format = format;
    const FormatInfo& info = plan.format();
    plan.entry.name = nameOf(clips.front(), info);
    const QString place = QDir(folder).filePath(fileNameOf(nameOfClip(clips.front())));
    const QString ending = QString::fromStdString(info.extensions.front());
    const auto isThere = [&info](const QString& file) {
        const std::filesystem::path path = toPath(file);
        std::error_code failure; // where nobody can look, exporting says so
        return std::filesystem::exists(
            info.onePerFrame ? path.parent_path() / numberedName(path, 0, 1) : path, failure);
    };
    QString free = place + ending;
    for (int number = 2; isThere(free); ++number)
        free = place + QStringLiteral("_%1").arg(number) + ending;
    plan.entry.path = free.toStdString();
    return plan;
}

std::string withEndingOf(const std::string& path, const FormatInfo& format)
{
    std::filesystem::path changed = path;
    changed.replace_extension(format.extensions.front());
    return changed.string();
}

} // namespace quadrille
