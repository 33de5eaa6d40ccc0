// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/geometrykernels.h"

#include "model/core/simd.h"
#include "model/core/simdmath.h"

#include <array>
#include <cmath>

namespace quadrille {

namespace {

/// Coordinates of the corners v1, v2, v3 in rows.
using Corners = std::array<std::array<std::array<float, sliceTriangles>, 3>, 3>;

/// They lie scattered. Not converted here: one by one that takes longer than all that follows.
[[gnu::always_inline]] inline void gatherCorners(const float* positions, const CornerSlice& corners,
                                                 Corners& rows)
{
    for (std::size_t corner = 0; corner < 3; ++corner) {
        for (std::size_t t = 0; t < sliceTriangles; ++t) {
            const float* p = positions + std::size_t{3} * corners.vertices[corner][t];
            for (std::size_t axis = 0; axis < 3; ++axis)
                rows[corner][axis][t] = p[axis];
        }
    }
}

struct Vector
{
    double x;
    double y;
    double z;
};

[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Quaternion
{
    double w;
    double x;
    double y;
    double z;
};

/// Of the rotation with columns x, y, z; of the quaternion's components the largest is found first. Written
/// so that no jump remains.
[[gnu::always_inline]] inline Quaternion quaternionOf(const Vector& x, const Vector& y, const Vector& z)
{
    // Four times the products of the components with w, then with another one where that is larger.
    const double x4 = 1 + x.x - y.y - z.z;
    const double y4 = 1 - x.x + y.y - z.z;
    const double z4 = 1 - x.x - y.y + z.z;
    double largest = 1 + x.x + y.y + z.z;
    Quaternion q{largest, y.z - z.y, z.x - x.z, x.y - y.x};
    const bool byX = x4 > largest;
    largest = byX ? x4 : largest;
    q.w = byX ? y.z - z.y : q.w;
    q.x = byX ? x4 : q.x;
    q.y = byX ? x.y + y.x : q.y;
    q.z = byX ? z.x + x.z : q.z;
    const bool byY = y4 > largest;
    largest = byY ? y4 : largest;
    q.w = byY ? z.x - x.z : q.w;
    q.x = byY ? x.y + y.x : q.x;
    q.y = byY ? y4 : q.y;
    q.z = byY ? y.z + z.y : q.z;
    const bool byZ = z4 > largest;
    largest = byZ ? z4 : largest;
    q.w = byZ ? x.y - y.x : q.w;
    q.x = byZ ? z.x + x.z : q.x;
    q.y = byZ ? y.z + z.y : q.y;
    q.z = byZ ? z4 : q.z;
    const double scale = 0.5 / std::sqrt(largest);
    return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

} // namespace

QUADRILLE_SIMD_CLONES
void fillTriangleFrames(const float* positions, const CornerSlice& corners, TriangleSlice& out)
{
    Corners rows;
    gatherCorners(positions, corners, rows);
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const Vector origin{double{rows[2][0][t]}, double{rows[2][1][t]}, double{rows[2][2][t]}};
        const Vector a{rows[0][0][t] - origin.x, rows[0][1][t] - origin.y, rows[0][2][t] - origin.z};
        const Vector b{rows[1][0][t] - origin.x, rows[1][1][t] - origin.y, rows[1][2][t] - origin.z};
        const Vector n = cross(a, b);
        const double length = std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
        const double area = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z); // of the parallelogram
        const double inverseLength = 1 / length;
        const double inverseArea = 1 / area;
        const Vector x{a.x * inverseLength, a.y * inverseLength, a.z * inverseLength};
        const Vector z{n.x * inverseArea, n.y * inverseArea, n.z * inverseArea};
        out.b11[t] = static_cast<float>(length);
        out.b12[t] = static_cast<float>(x.x * b.x + x.y * b.y + x.z * b.z);
        out.b22[t] = static_cast<float>(area * inverseLength);
        out.logArea[t] = logarithm(static_cast<float>(area));
        const Quaternion q = quaternionOf(x, cross(z, x), z);
        out.quaternion[0][t] = static_cast<float>(q.w);
        out.quaternion[1][t] = static_cast<float>(q.x);
        out.quaternion[2][t] = static_cast<float>(q.y);
        out.quaternion[3][t] = static_cast<float>(q.z);
    }
}

QUADRILLE_SIMD_CLONES
void addProducts(const float* left, const float* right, std::size_t rowTiles, std::size_t columnTiles,
                 double* sums)
{
    const std::size_t stride = columnTiles * productColumns;
    for (std::size_t tile = 0; tile < rowTiles * columnTiles; ++tile) {
        const std::size_t rowTile = tile % rowTiles;
        const std::size_t columnTile = tile / rowTiles;
        const float* rightPanel = right + columnTile * productDepth * productColumns;
        const float* leftPanel = left + rowTile * productDepth * productRows;
        double* out = sums + rowTile * productRows * stride + columnTile * productColumns;
        for (std::size_t first = 0; first < productDepth; first += singleDepth) {
            float part[productRows][productColumns] = {};
            for (std::size_t k = first; k < first + singleDepth; ++k) {
                for (std::size_t row = 0; row < productRows; ++row) {
#pragma omp simd
                    for (std::size_t column = 0; column < productColumns; ++column)
                        part[row][column] +=
                            leftPanel[k * productRows + row] * rightPanel[k * productColumns + column];
                }
            }
            for (std::size_t row = 0; row < productRows; ++row) {
#pragma omp simd
                for (std::size_t column = 0; column < productColumns; ++column)
                    out[row * stride + column] += double{part[row][column]};
            }
        }
    }
}

} // namespace quadrille
