// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/theme.h"

#include <QIcon>
#include <QPixmap>
#include <QStringList>

namespace quadrille::widgets {

/// The application's own line icons. They are drawn at the size and scale asked for, with strokes of
/// 1.5 pixels, in the theme's text colour (accent when on, faint when disabled), and follow the theme.
namespace icons {

/// \param name  file name in resources/icons/ without ".svg", e.g. "play".
/// \param role  colour when off and enabled.
/// \pre the icon exists.
QIcon icon(const QString& name, ColorRole role = ColorRole::Text);

/// One picture of an icon, in one colour. \param size logical pixels, square.
QPixmap pixmap(const QString& name, int size, const QColor& color, double devicePixelRatio);

/// Names of all icons there are.
QStringList names();

/// The icon of the application, in its own colours.
QIcon application();

} // namespace icons

} // namespace quadrille::widgets
