// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of transfers; as those of projectedits.h.

/// \return the name that the transfer got.
QString addTransfer(ProjectDocument& document, TransferEntry transfer);
/// \return the copy's name.
QString duplicateTransfer(ProjectDocument& document, const QString& name);
/// Exchanges the values of a transfer; its name stays.
/// \param text what the history calls the edit, translated.
/// \param property tells what is edited: steps of a drag of the same property merge.
void setTransfer(ProjectDocument& document, const QString& name, const QString& text, const QString& property,
                 TransferEntry after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
