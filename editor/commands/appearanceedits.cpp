// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/appearanceedits.h"

#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct AppearanceTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::AppearanceEdits)
};

} // namespace

QString addAppearance(ProjectDocument& document, AppearanceEntry appearance)
{
    return addEntry(document, AppearanceTexts::tr("Add appearance “%1”"), std::move(appearance));
}

QString duplicateAppearance(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<AppearanceEntry>(document, AppearanceTexts::tr("Duplicate “%1”").arg(name), name);
}

void setAppearance(ProjectDocument& document, const QString& name, const QString& text,
                   const QString& property, AppearanceEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

} // namespace quadrille
