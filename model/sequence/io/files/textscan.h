// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <charconv>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace quadrille {

/// Reads a number, an optional sign before it. Too small a number becomes 0, too large a one infinite.
/// \return the place behind it, or null when there is none.
template <typename Number>
const char* scanNumber(const char* at, const char* end, Number& value)
{
    if (at != end && *at == '+')
        ++at;
    const auto result = std::from_chars(at, end, value);
    if (result.ec == std::errc()) [[likely]]
        return result.ptr;
    if constexpr (std::is_same_v<Number, float>) {
        double wide = 0;
        if (result.ec == std::errc::result_out_of_range && std::from_chars(at, end, wide).ec == std::errc()) {
            value = static_cast<float>(wide);
            return result.ptr;
        }
    }
    return nullptr;
}

inline const char* skipBlanks(const char* at, const char* end)
{
    while (at != end && (*at == ' ' || *at == '\t'))
        ++at;
    return at;
}

/// The place behind the next line end, or `end`.
inline const char* nextLine(const char* at, const char* end)
{
    const void* const found = std::memchr(at, '\n', static_cast<std::size_t>(end - at));
    return found ? static_cast<const char*>(found) + 1 : end;
}

/// The line at the start of `text`, without its end and the blanks around it; `text` loses it.
std::string_view takeLine(std::string_view& text);

/// The word at the start of `line`; `line` loses it and the blanks around it.
std::string_view takeWord(std::string_view& line);

/// One-based line of a place in a text.
std::int64_t lineOf(std::string_view text, const char* at);

/// Throws FileSyntax with the line of a place.
[[noreturn]] void throwSyntax(const std::filesystem::path& file, std::string_view text, const char* at,
                              std::string reason);

/// Refuses text in UTF-16 or UTF-32 and binary data. Any 8-bit encoding passes: comments may be in it.
/// \return the text without a byte order mark.
/// \throws Error FileEncoding.
std::string_view checkedText(std::string_view text, const std::filesystem::path& file);

} // namespace quadrille
