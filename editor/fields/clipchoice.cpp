// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/clipchoice.h"

#include "model/project/document/project.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFont>
#include <QStandardItemModel>
#include <algorithm>

namespace quadrille {

namespace {

struct Texts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ClipChoice)
};

template <typename Entries>
QStringList clipsOf(const Entries& entries, const QString& section)
{
    QStringList clips;
    for (const auto& entry : entries)
        clips += section + QString::fromStdString(entry.name);
    return clips;
}

void addHeading(QComboBox& box, const QString& text)
{
    box.addItem(text);
    auto* item = qobject_cast<QStandardItemModel*>(box.model())->item(box.count() - 1);
    item->setFlags(Qt::NoItemFlags);
    QFont font = box.font();
    font.setBold(true);
    item->setFont(font);
}

} // namespace

void listClips(QComboBox& box, const Project& project, const QStringList& planned)
{
    box.clear();
    if (planned.size() > 1) {
        box.addItem(nameOfClip(planned.front()), planned.front());
        return;
    }
    const std::pair<QString, QStringList> kinds[] = {
        {Texts::tr("Takes"), clipsOf(project.sequences, QStringLiteral("sequences/"))},
        {Texts::tr("Animations"), clipsOf(project.animations, QStringLiteral("animations/"))},
        {Texts::tr("Variations"), clipsOf(project.variations, QStringLiteral("variations/"))},
        {Texts::tr("Live performances"), clipsOf(project.lives, QStringLiteral("live/"))},
        {Texts::tr("Transfers"), clipsOf(project.transfers, QStringLiteral("transfers/"))},
        {Texts::tr("Projections"), clipsOf(project.projections, QStringLiteral("projections/"))}};
    const auto count = std::count_if(std::begin(kinds), std::end(kinds),
                                     [](const auto& kind) { return !kind.second.isEmpty(); });
    for (const auto& [heading, clips] : kinds) {
        if (count > 1 && !clips.isEmpty())
            addHeading(box, heading);
        for (const QString& clip : clips)
            box.addItem(nameOfClip(clip), clip);
    }
    // One variation alone has no line of its own, but an export may be about it.
    if (!planned.isEmpty() && box.findData(planned.front()) < 0)
        box.addItem(nameOfClip(planned.front()), planned.front());
}

QString nameOfClip(const QString& clip)
{
    return clip.section(QLatin1Char('/'), 1);
}

} // namespace quadrille
