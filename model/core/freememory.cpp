// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/freememory.h"

#include "model/core/largeblocks.h"

#include <cstdlib> // tells which C library it is
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace quadrille {

void returnFreeMemory()
{
    releaseLargeBlocks();
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace quadrille
