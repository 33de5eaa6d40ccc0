// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

class QComboBox;

namespace quadrille {

/// Gives a box that chooses among entries by name the width of its names: at least that of a few letters, at
/// most what leaves room for what stands beside it. Longer names are cut.
void fitToNames(QComboBox& box);

} // namespace quadrille
