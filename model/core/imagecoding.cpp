// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/imagecoding.h"

#include <cmath>
#include <string_view>

namespace quadrille {

namespace {

constexpr std::string_view pngStart = "\x89PNG\r\n\x1a\n";

std::uint32_t bigEndianAt(std::span<const std::byte> bytes, std::size_t at)
{
    std::uint32_t value = 0;
    for (const std::byte byte : bytes.subspan(at, 4))
        value = value << 8U | std::to_integer<std::uint32_t>(byte);
    return value;
}

} // namespace

std::optional<double> codingExponent(std::span<const std::byte> encoded)
{
    const std::string_view text(reinterpret_cast<const char*>(encoded.data()), encoded.size());
    if (!text.starts_with(pngStart))
        return std::nullopt;
    constexpr std::size_t around = 12; // length, type, checksum
    std::optional<double> exponent;
    for (std::size_t at = pngStart.size(); at + around <= text.size();) {
        const std::string_view type = text.substr(at + 4, 4);
        const std::size_t length = bigEndianAt(encoded, at);
        if (type == "IDAT" || type == "IEND") // marks stand before the pixels
            break;
        if (type == "sRGB" || type == "iCCP" || type == "cICP")
            return std::nullopt;
        if (type == "gAMA" && length == 4 && at + around + length <= text.size())
            exponent = bigEndianAt(encoded, at + 8) / 100'000.0;
        at += length + around;
    }
    constexpr double least = 0.1;
    constexpr double most = 10;
    if (!exponent || *exponent < least || *exponent > most || std::abs(*exponent * 2.2 - 1) < 0.05)
        return std::nullopt;
    return exponent;
}

std::vector<std::uint8_t> srgbOfSamples(double exponent, int levels)
{
    std::vector<std::uint8_t> values;
    values.reserve(static_cast<std::size_t>(levels));
    for (int sample = 0; sample < levels; ++sample) {
        const double light = std::pow(static_cast<double>(sample) / (levels - 1), 1 / exponent);
        const double srgb = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
        values.push_back(static_cast<std::uint8_t>(std::lround(255 * srgb)));
    }
    return values;
}

} // namespace quadrille
