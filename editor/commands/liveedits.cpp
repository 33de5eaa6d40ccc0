// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/liveedits.h"

#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct LiveTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::LiveEdits)
};

} // namespace

QString addLive(ProjectDocument& document, LiveEntry live)
{
    return addEntry(document, LiveTexts::tr("Record “%1”"), std::move(live));
}

void setLive(ProjectDocument& document, const QString& name, const QString& text, const QString& property,
             LiveEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

} // namespace quadrille
