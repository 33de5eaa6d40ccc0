// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace quadrille {

inline constexpr int windowReach = 5; ///< pixels from the middle of a window to its end
inline constexpr int windowWidth = 2 * windowReach + 1;
inline constexpr int momentCount = 5; ///< of two lumas a and b: a, b, a² + b², a · b, 1
inline constexpr float lumaMiddle =
    128; ///< what lumas are lessened by, so that their squares lose fewer digits

/// The moments of the pixels of a row; 0 where mask is.
/// \param mask  null: all count. \param moments  of each, the first pixel; they lie `stride` apart.
void pixelMoments(const std::uint8_t* first, const std::uint8_t* second, const std::uint8_t* mask, int width,
                  float* moments, int stride);

/// Weighted sums of a row. \param values  width + 2 · windowReach.
void filterRow(const float* values, int width, const float* weights, float* sums);

/// SSIM of a row of pixels from moments of the windowWidth rows around it that were filtered along
/// themselves. \param rows  of each, momentCount × width.
void similarityOfRow(const float* const* rows, int width, const float* weights, float* moments,
                     float* similarity);

} // namespace quadrille
