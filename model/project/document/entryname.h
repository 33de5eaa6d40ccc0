// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace quadrille {

/// Longest name of an entry, bytes of UTF-8: files are named after it, with an ending and, while they are
/// written, a number.
inline constexpr std::size_t longestName = 200;

/// A sentence's reason why a name cannot be used, or nothing. Names are parts of targets ("sequences/NAME").
std::optional<std::string> problemWithName(const std::string& name);

} // namespace quadrille
