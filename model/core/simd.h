// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

/// Before a function: compiles it for AVX-512, for AVX2 and for any x86-64, and takes the best that the
/// machine knows when the program starts. What it calls must be inlined into it. Source files with such
/// kernels are listed in quadrille_kernels(…) of their CMakeLists.txt, which lets the compiler reorder sums.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define QUADRILLE_SIMD_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define QUADRILLE_SIMD_CLONES
#endif
