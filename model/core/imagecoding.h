// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// How a PNG file says that its samples are coded, where that is not sRGB: the exponent of its chunk gAMA, so
/// that sample = light ^ exponent (1: linear light).
///
/// None where it says nothing, has a chunk that counts more (sRGB, iCCP, cICP), a value that makes no sense,
/// or one within a twentieth of 1 / 2.2, which stands for sRGB. None for other formats.
std::optional<double> codingExponent(std::span<const std::byte> encoded);

/// The sRGB value (IEC 61966-2-1) of each sample 0 … levels − 1. \param exponent  see codingExponent.
std::vector<std::uint8_t> srgbOfSamples(double exponent, int levels);

} // namespace quadrille
