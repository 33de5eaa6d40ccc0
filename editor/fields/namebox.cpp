// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/fields/namebox.h"

#include <QComboBox>

namespace quadrille {

void fitToNames(QComboBox& box)
{
    constexpr int fewestLetters = 10;
    constexpr int widest = 280; // pixels
    box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
    box.setMinimumContentsLength(fewestLetters);
    box.setMaximumWidth(widest);
}

} // namespace quadrille
