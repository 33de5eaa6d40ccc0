// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <functional>

namespace quadrille {

/// Sets a widget's texts now and again whenever the language changes: every `setText(tr(…))` belongs in here,
/// never into a constructor. Texts that depend on values are best set by the function that also shows the
/// values, called from here.
///
///     retranslates(this, [this] {
///         setWindowTitle(tr("Preferences"));
///         m_theme->setItemText(0, tr("As the system"));
///     });
void retranslates(QWidget* widget, std::function<void()> setTexts);

} // namespace quadrille
