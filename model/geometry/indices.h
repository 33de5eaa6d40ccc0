// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace quadrille {

/// A signed index that is known not to be negative, as containers want it.
constexpr std::size_t at(std::int32_t index)
{
    return static_cast<std::size_t>(index);
}

} // namespace quadrille
