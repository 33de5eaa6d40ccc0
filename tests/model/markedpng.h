// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::test {

inline std::string bigEndian(std::uint32_t value)
{
    return {static_cast<char>(value >> 24U), static_cast<char>(value >> 16U), static_cast<char>(value >> 8U),
            static_cast<char>(value)};
}

/// A PNG file with one more chunk before its pixels, right behind IHDR.
inline std::vector<std::byte> withPngChunk(std::vector<std::byte> png, std::string_view type,
                                           std::string_view data)
{
    std::uint32_t sum = ~0U;
    const std::string summed = std::string(type) + std::string(data);
    for (const char character : summed) {
        sum ^= static_cast<unsigned char>(character);
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    const std::string chunk = bigEndian(static_cast<std::uint32_t>(data.size())) + summed + bigEndian(~sum);
    const auto bytes = std::as_bytes(std::span(chunk));
    constexpr std::ptrdiff_t behindHeader = 33;
    png.insert(png.begin() + behindHeader, bytes.begin(), bytes.end());
    return png;
}

/// A PNG file that says sample = light ^ exponent. \param exponent  in 1 / 100,000.
inline std::vector<std::byte> withPngGamma(std::vector<std::byte> png, std::uint32_t exponent)
{
    return withPngChunk(std::move(png), "gAMA", bigEndian(exponent));
}

} // namespace quadrille::test
