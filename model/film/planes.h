// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

namespace quadrille {

/// A picture as films hold it: brightness at every pixel, colour at every second of every second row.
///
/// The matrix is that of ITU-R BT.709, which players take for pictures of this kind, in the range of films:
/// black is 16, white 235, grey 128. The colour of a sample is that of its even column, between its two rows,
/// as H.264 and VP9 have it where nothing else is said.
struct Planes
{
    int width = 0;
    int height = 0;
    int colorWidth = 0;                 ///< (width + 1) / 2
    int colorHeight = 0;                ///< (height + 1) / 2
    std::vector<std::uint8_t> luma;     ///< height × width
    std::vector<std::uint8_t> blueness; ///< colorHeight × colorWidth, Cb
    std::vector<std::uint8_t> redness;  ///< colorHeight × colorWidth, Cr
};

/// Opacity is left out. `out` is given to save making it anew for every picture.
void toPlanes(const Image& picture, Planes& out);

/// The picture that planes hold; colour between two even columns is the mean of both. All of it is opaque.
Image fromPlanes(const Planes& planes);

} // namespace quadrille
