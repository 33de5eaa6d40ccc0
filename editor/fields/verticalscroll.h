// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class QScrollArea;
class QWidget;

namespace quadrille {

/// A frameless area, as wide as its place, in which a form scrolls up and down where it is higher than that.
/// It keeps as wide as the form needs, some 50 characters at most. \param content  becomes the area's.
QScrollArea* verticalScroll(QWidget* content);

} // namespace quadrille
