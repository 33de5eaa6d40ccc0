// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

namespace quadrille::widgets {

/// The text with places, which nobody sees, where lines may break: between the parts of paths and names that
/// are put together, and within words of more than 24 characters. So a long name does not widen its label.
QString breakable(const QString& text);

} // namespace quadrille::widgets
