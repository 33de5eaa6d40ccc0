// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

namespace quadrille {

/// Gives memory that was freed back to the system, as far as the allocator keeps whole pages of it: after
/// many small things were let go, before large ones are made. Cost: linear in the free memory, some ms.
/// Nothing where the C library knows no such thing.
void returnFreeMemory();

} // namespace quadrille
