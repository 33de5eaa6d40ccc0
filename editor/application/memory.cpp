// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/application/memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quadrille {

void returnLargeBlocks()
{
#ifdef __GLIBC__
    constexpr int largeBytes = 1 << 20;
    // A threshold that is set does not rise with what was freed, as it does by itself.
    mallopt(M_MMAP_THRESHOLD, largeBytes);
#endif
}

} // namespace quadrille
