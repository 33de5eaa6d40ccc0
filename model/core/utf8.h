// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace quadrille {

/// Whether a text is well-formed UTF-8: no overlong forms, surrogates or code points beyond U+10FFFF.
bool isUtf8(std::string_view text);

/// The longest beginning of at most `bytes` bytes that ends between two characters.
std::string cutUtf8(std::string_view text, std::size_t bytes);

} // namespace quadrille
