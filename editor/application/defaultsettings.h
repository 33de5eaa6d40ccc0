// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace quadrille {

/// Puts settings that cannot be read aside: the program has default ones then. Call before anything reads
/// settings.
/// \return where they are now; empty when all is well.
QString checkSettings();

/// Asks whether to start with default settings after several starts failed. Yes where nobody can answer, and
/// when nobody does within half a minute. Blocks until it is answered. Needs a QApplication.
bool askForDefaultSettings(int failedStarts);

/// Puts settings and sessions aside, beside where they were. The language and the list of recent projects
/// stay; everything else is as it is by default then.
/// \return where the settings are now.
QString takeDefaultSettings();

} // namespace quadrille
