// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/projectdocument.h"

namespace quadrille {

// Edits of live performances; as those of projectedits.h.

/// \return the name that the performance got.
QString addLive(ProjectDocument& document, LiveEntry live);

} // namespace quadrille
