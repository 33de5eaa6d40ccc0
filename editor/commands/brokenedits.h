// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

#include <QStringList>

namespace quadrille {

// Edits of what cannot be read of a project; as those of projectedits.h. Such parts are selected and shown as
// entries of the section Project, by their titles.

/// Takes parts out of the project.
void removeBroken(ProjectDocument& document, const QStringList& titles);
/// Exchanges the text of a part, and reads all of them again: those that can be read by now are entries like
/// others.
/// \param json as it shall stand in the file.
/// \return whether it was taken; it is refused where it is no JSON.
bool setBroken(ProjectDocument& document, const QString& title, const QString& json);

} // namespace quadrille
