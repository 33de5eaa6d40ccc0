// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QList>

class QAbstractItemView;
class QAction;

namespace quadrille {

/// Gives a list a menu at the right mouse button: what can be done with the rows chosen, and a copy of their
/// texts, their columns separated by tabs. The actions become the list's as well, so that their shortcuts
/// work in it.
void addRightMenu(QAbstractItemView& list, const QList<QAction*>& actions = {});

} // namespace quadrille
