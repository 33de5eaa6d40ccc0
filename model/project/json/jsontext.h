// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/project/json/json.h"

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace quadrille {

/// A JSON document together with where in its text each value stands.
struct JsonText
{
    struct Location
    {
        ErrorPlace key;   ///< of the member's key; of the value where there is none
        ErrorPlace value; ///< of the value's first character
    };

    Json document;
    /// By JSON pointer ("/sequences/3/range"); the whole document is "".
    std::map<std::string, Location, std::less<>> locations;

    /// Place of a value, or of the nearest enclosing value that exists.
    ErrorPlace placeOf(std::string_view pointer) const;
    ErrorPlace placeOfKey(std::string_view pointer) const;
};

/// Deepest nesting that is read.
inline constexpr int maxJsonDepth = 100;

/// Parses UTF-8 JSON. Lines and columns are one-based and count characters, not bytes.
/// \param file names the text in errors.
/// \throws Error ProjectSyntax (also for a key that appears twice and for nesting beyond maxJsonDepth),
/// FileEncoding; each with line and column.
JsonText parseJson(std::string_view text, const std::filesystem::path& file = {});

/// JSON text with two-space indent and a final newline; arrays of plain numbers stand on one line. Whole
/// numbers are written without a fraction.
std::string writeJson(const Json& document);

/// `text` as one reference token of a JSON pointer.
std::string escapePointer(std::string_view text);

} // namespace quadrille
