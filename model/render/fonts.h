// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace quadrille {

/// DejaVu Sans as a TrueType file.
std::span<const unsigned char> regularFont();
std::span<const unsigned char> boldFont();

} // namespace quadrille
