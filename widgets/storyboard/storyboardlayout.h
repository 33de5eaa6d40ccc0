// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

/// Measures of a storyboard's cards, logical pixels.
namespace quadrille::widgets::storyboard {

constexpr int cardWidth = 112;
constexpr int pictureSide = 64;
constexpr int gap = 16; ///< between cards
constexpr int margin = 6;
constexpr int lineHeight = 4; ///< of the coloured line

} // namespace quadrille::widgets::storyboard
