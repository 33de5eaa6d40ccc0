// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace quadrille {

/// Whether a value is among others.
template <typename Values, typename Value>
bool contains(const Values& values, const Value& value)
{
    return std::ranges::find(values, value) != std::ranges::end(values);
}

} // namespace quadrille
