// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

// A pass of a search ends where it knows so many states, whatever is left of its budget: half a gigabyte, and
// as much again for what is known of each.
inline constexpr std::size_t mostVisits = 8'000'000;
inline constexpr std::size_t mostKnownStates = 24'000'000;

} // namespace quadrille
