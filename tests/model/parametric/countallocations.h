// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille::test {

/// How often the program has asked for memory by operator new.
std::size_t allocationCount();

} // namespace quadrille::test
