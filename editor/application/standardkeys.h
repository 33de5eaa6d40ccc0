// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QKeySequence>
#include <QList>

namespace quadrille {

/// The keys of an action that every program has. First those that the manual names, which are the same on
/// every desktop; then the desktop's own, where it has others. (A plain X11 session has none for “Save as” or
/// “Quit”.)
QList<QKeySequence> standardKeys(QKeySequence::StandardKey key);

} // namespace quadrille
