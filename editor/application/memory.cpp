// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quadrille {

void keepMemoryTight()
{
#ifdef __GLIBC__
    constexpr int largeBytes = 1 << 20;
    constexpr int arenas = 4;
    // A threshold that is set does not rise with what was freed, as it does by itself.
    mallopt(M_MMAP_THRESHOLD, largeBytes);
    // Each arena keeps free memory of its own; by itself there would be one for nearly every thread.
    mallopt(M_ARENA_MAX, arenas);
#endif
}

} // namespace quadrille
