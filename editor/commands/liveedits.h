// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of live performances; as those of projectedits.h.

/// \return the name that the performance got.
QString addLive(ProjectDocument& document, LiveEntry live);
/// Exchanges the values of a performance; its name stays. \param text, property  as setTransfer.
void setLive(ProjectDocument& document, const QString& name, const QString& text, const QString& property,
             LiveEntry after, EditPhase phase = EditPhase::Final);

} // namespace quadrille
