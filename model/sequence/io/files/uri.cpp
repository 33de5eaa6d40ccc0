// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/uri.h"

#include <charconv>
#include <cstdint>

namespace quadrille {

std::optional<std::vector<std::byte>> decodeBase64(std::string_view text)
{
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t bits = 0;
    int bitCount = 0;
    while (text.ends_with('='))
        text.remove_suffix(1);
    for (const char c : text) {
        std::uint32_t six = 0;
        if (c >= 'A' && c <= 'Z')
            six = static_cast<std::uint32_t>(c - 'A');
        else if (c >= 'a' && c <= 'z')
            six = static_cast<std::uint32_t>(c - 'a') + 26;
        else if (c >= '0' && c <= '9')
            six = static_cast<std::uint32_t>(c - '0') + 52;
        else if (c == '+' || c == '/')
            six = c == '+' ? 62 : 63;
        else
            return std::nullopt;
        bits = bits << 6 | six;
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<std::byte>(bits >> bitCount));
        }
    }
    return bytes;
}

std::string percentDecoded(std::string_view uri)
{
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(uri.data() + i + 1, uri.data() + i + 3, value, 16).ptr == uri.data() + i + 3) {
            decoded += static_cast<char>(value);
            i += 2;
        } else {
            decoded += uri[i];
        }
    }
    return decoded;
}

} // namespace quadrille
