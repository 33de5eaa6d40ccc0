// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <optional>

namespace quadrille::widgets {

/// Whether the desktop prefers dark windows; nothing when it does not say. Asks the settings portal
/// (org.freedesktop.appearance), then GTK_THEME. Qt 6.4 has no interface for it.
std::optional<bool> systemPrefersDark();

/// Calls a slot (QString group, QString key) whenever a setting of the desktop changes.
void connectToSystemScheme(QObject* receiver, const char* slot);

} // namespace quadrille::widgets
