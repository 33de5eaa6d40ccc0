// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace quadrille {

/// Makes sure that the positions of a clip fit into memory, before any is asked for.
/// \throws Error BadArgument where they would take more than 16 GB.
void checkClipSize(std::int64_t frames, std::size_t vertices);

} // namespace quadrille
