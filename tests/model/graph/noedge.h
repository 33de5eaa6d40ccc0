// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace quadrille {

/// The cost where no transition leads.
constexpr float noEdge = std::numeric_limits<float>::infinity();

} // namespace quadrille
