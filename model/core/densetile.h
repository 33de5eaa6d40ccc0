// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

// What the dense kernels are built of; everything is inlined into their clones.

namespace quadrille::dense {

/// Four numbers fit the registers of AVX2; wider vectors would lie in memory there.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

constexpr std::ptrdiff_t tileRows = 4;
constexpr std::ptrdiff_t tileColumns = 8;

/// Elements of the left operand of a product: (r, k) is at[r·row + k·step].
struct Left
{
    const double* at;
    std::ptrdiff_t row;
    std::ptrdiff_t step;
};

/// Four rows of eight numbers, in registers.
struct Tile
{
    Four a0{};
    Four a1{};
    Four a2{};
    Four a3{};
    Four b0{};
    Four b1{};
    Four b2{};
    Four b3{};
};

/// Adds Σ_k left(r, k) · panel(k, ·) for k from begin to end. Rows of the panel are eight numbers apart.
[[gnu::always_inline]] inline void addProduct(Tile& tile, Left left, const double* panel,
                                              std::ptrdiff_t begin, std::ptrdiff_t end)
{
    const double* l = left.at + begin * left.step;
    const double* p = panel + begin * tileColumns;
    for (std::ptrdiff_t k = begin; k < end; ++k, l += left.step, p += tileColumns) {
        const Four a = *reinterpret_cast<const Four*>(p);
        const Four b = *reinterpret_cast<const Four*>(p + 4);
        tile.a0 += a * l[0];
        tile.b0 += b * l[0];
        tile.a1 += a * l[left.row];
        tile.b1 += b * l[left.row];
        tile.a2 += a * l[2 * left.row];
        tile.b2 += b * l[2 * left.row];
        tile.a3 += a * l[3 * left.row];
        tile.b3 += b * l[3 * left.row];
    }
}

[[gnu::always_inline]] inline void store(double* out, const Four& a, const Four& b)
{
    *reinterpret_cast<Four*>(out) = a;
    *reinterpret_cast<Four*>(out + 4) = b;
}

[[gnu::always_inline]] inline void storeTile(double* out, std::ptrdiff_t stride, const Tile& tile)
{
    store(out, tile.a0, tile.b0);
    store(out + stride, tile.a1, tile.b1);
    store(out + 2 * stride, tile.a2, tile.b2);
    store(out + 3 * stride, tile.a3, tile.b3);
}

} // namespace quadrille::dense
