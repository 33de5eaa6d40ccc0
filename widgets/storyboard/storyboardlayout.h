// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

/// Measures of a storyboard's cards, logical pixels.
namespace quadrille::widgets::storyboard {

constexpr int cardWidth = 112;
constexpr int pictureSide = 64; ///< where there is room
constexpr int smallestPicture = 24;
constexpr int gap = 16;  ///< between cards
constexpr int above = 8; ///< and below
constexpr int margin = 6;
constexpr int lineHeight = 4; ///< of the coloured line

} // namespace quadrille::widgets::storyboard
