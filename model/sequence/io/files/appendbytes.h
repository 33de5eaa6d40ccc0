// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <string>

namespace quadrille {

/// Appends a value as it lies in memory.
template <typename Value>
void appendBytes(std::string& bytes, const Value& value)
{
    const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
    bytes.append(raw.data(), raw.size());
}

} // namespace quadrille
