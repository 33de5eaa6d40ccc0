// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/geometrykernels.h"

#include "model/core/simd.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

QUADRILLE_SIMD_CLONES
void fillTriangleFrames(const float* positions, const CornerSlice& corners, TriangleSlice& out)
{
    const auto& [v1, v2, v3] = corners.vertices;
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const float* p1 = positions + std::size_t{3} * v1[t];
        const float* p2 = positions + std::size_t{3} * v2[t];
        const float* p3 = positions + std::size_t{3} * v3[t];
        const double ax = double{p1[0]} - p3[0];
        const double ay = double{p1[1]} - p3[1];
        const double az = double{p1[2]} - p3[2];
        const double bx = double{p2[0]} - p3[0];
        const double by = double{p2[1]} - p3[1];
        const double bz = double{p2[2]} - p3[2];
        const double nx = ay * bz - az * by;
        const double ny = az * bx - ax * bz;
        const double nz = ax * by - ay * bx;
        const double a = std::sqrt(ax * ax + ay * ay + az * az);
        const double n = std::sqrt(nx * nx + ny * ny + nz * nz);
        // columns of the frame: x = a/|a|, z = n/|n|, y = z × x
        const double xx = ax / a;
        const double xy = ay / a;
        const double xz = az / a;
        const double zx = nx / n;
        const double zy = ny / n;
        const double zz = nz / n;
        const double yx = zy * xz - zz * xy;
        const double yy = zz * xx - zx * xz;
        const double yz = zx * xy - zy * xx;
        out.b11[t] = static_cast<float>(a);
        out.b12[t] = static_cast<float>(xx * bx + xy * by + xz * bz);
        out.b22[t] = static_cast<float>(n / a);

        // The component of the quaternion that is largest is found from the diagonal, the others by it.
        const double w4 = 1 + xx + yy + zz;
        const double x4 = 1 + xx - yy - zz;
        const double y4 = 1 - xx + yy - zz;
        const double z4 = 1 - xx - yy + zz;
        const bool upper = std::max(w4, x4) >= std::max(y4, z4);
        const bool first = upper ? w4 >= x4 : y4 >= z4;
        const double largest = upper ? (first ? w4 : x4) : (first ? y4 : z4);
        const double wx = yz - zy;
        const double wy = zx - xz;
        const double wz = xy - yx;
        const double xy2 = xy + yx;
        const double xz2 = zx + xz;
        const double yz2 = yz + zy;
        const double scale = 0.5 / std::sqrt(largest);
        const double qw = upper ? (first ? largest : wx) : (first ? wy : wz);
        const double qx = upper ? (first ? wx : largest) : (first ? xy2 : xz2);
        const double qy = upper ? (first ? wy : xy2) : (first ? largest : yz2);
        const double qz = upper ? (first ? wz : xz2) : (first ? yz2 : largest);
        out.quaternion[0][t] = static_cast<float>(qw * scale);
        out.quaternion[1][t] = static_cast<float>(qx * scale);
        out.quaternion[2][t] = static_cast<float>(qy * scale);
        out.quaternion[3][t] = static_cast<float>(qz * scale);
    }
}

QUADRILLE_SIMD_CLONES
void addProducts(const float* left, const float* right, std::size_t rowTiles, std::size_t columnTiles,
                 double* sums)
{
    const std::size_t stride = columnTiles * productColumns;
    for (std::size_t columnTile = 0; columnTile < columnTiles; ++columnTile) {
        const float* rightPanel = right + columnTile * productDepth * productColumns;
        for (std::size_t rowTile = 0; rowTile < rowTiles; ++rowTile) {
            const float* leftPanel = left + rowTile * productDepth * productRows;
            float tile[productRows][productColumns] = {};
            for (std::size_t k = 0; k < productDepth; ++k) {
                for (std::size_t row = 0; row < productRows; ++row) {
#pragma omp simd
                    for (std::size_t column = 0; column < productColumns; ++column)
                        tile[row][column] +=
                            leftPanel[k * productRows + row] * rightPanel[k * productColumns + column];
                }
            }
            double* out = sums + rowTile * productRows * stride + columnTile * productColumns;
            for (std::size_t row = 0; row < productRows; ++row) {
#pragma omp simd
                for (std::size_t column = 0; column < productColumns; ++column)
                    out[row * stride + column] += double{tile[row][column]};
            }
        }
    }
}

} // namespace quadrille
