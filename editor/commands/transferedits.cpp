// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/transferedits.h"

#include "editor/commands/entryedits.h"

#include <QCoreApplication>

namespace quadrille {

namespace {

struct TransferTexts
{
    Q_DECLARE_TR_FUNCTIONS(quadrille::TransferEdits)
};

} // namespace

QString addTransfer(ProjectDocument& document, TransferEntry transfer)
{
    return addEntry(document, TransferTexts::tr("Add transfer “%1”"), std::move(transfer));
}

QString duplicateTransfer(ProjectDocument& document, const QString& name)
{
    return duplicateEntry<TransferEntry>(document, TransferTexts::tr("Duplicate “%1”").arg(name), name);
}

void setTransfer(ProjectDocument& document, const QString& name, const QString& text, const QString& property,
                 TransferEntry after, EditPhase phase)
{
    setEntry(document, name, text, property, std::move(after), phase);
}

} // namespace quadrille
