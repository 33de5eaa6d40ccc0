// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// The bytes of base64 text; nothing if it is none.
std::optional<std::vector<std::byte>> decodeBase64(std::string_view text);

/// A URI with %20 and the like turned back into characters.
std::string percentDecoded(std::string_view uri);

} // namespace quadrille
