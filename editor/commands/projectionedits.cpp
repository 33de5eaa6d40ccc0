// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/projectionedits.h"

#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct ProjectionTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::ProjectionEdits)
};

} // namespace

QString addProjection(ProjectDocument& document, ProjectionEntry projection)
{
    return addEntry(document, ProjectionTexts::tr("Add 3D video “%1”"), std::move(projection));
}

QString duplicateProjection(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<ProjectionEntry>(document, ProjectionTexts::tr("Duplicate “%1”").arg(name), name);
}

void setProjection(ProjectDocument& document, const QString& name, const QString& text,
                   const QString& property, ProjectionEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

} // namespace quadrille
