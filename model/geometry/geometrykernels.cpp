// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/geometrykernels.h"

#include "model/core/simd.h"
#include "model/core/simdmath.h"

#include <array>
#include <cmath>

namespace quadrille {

QUADRILLE_SIMD_CLONES
void fillTriangleFrames(const float* positions, const CornerSlice& corners, TriangleSlice& out)
{
    // First the edges v1−v3 and v2−v3, which lie scattered; then loops without a jump.
    using Edge = std::array<std::array<double, sliceTriangles>, 3>;
    Edge a;
    Edge b;
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const float* p1 = positions + std::size_t{3} * corners.vertices[0][t];
        const float* p2 = positions + std::size_t{3} * corners.vertices[1][t];
        const float* p3 = positions + std::size_t{3} * corners.vertices[2][t];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            a[axis][t] = double{p1[axis]} - p3[axis];
            b[axis][t] = double{p2[axis]} - p3[axis];
        }
    }
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const double ax = a[0][t];
        const double ay = a[1][t];
        const double az = a[2][t];
        const double bx = b[0][t];
        const double by = b[1][t];
        const double bz = b[2][t];
        const double nx = ay * bz - az * by;
        const double ny = az * bx - ax * bz;
        const double nz = ax * by - ay * bx;
        const double length = std::sqrt(ax * ax + ay * ay + az * az);
        const double area = std::sqrt(nx * nx + ny * ny + nz * nz); // of the parallelogram
        const double inverseLength = 1 / length;
        const double inverseArea = 1 / area;
        // columns of the frame: x along a, z the normal, y = z × x
        const double xx = ax * inverseLength;
        const double xy = ay * inverseLength;
        const double xz = az * inverseLength;
        const double zx = nx * inverseArea;
        const double zy = ny * inverseArea;
        const double zz = nz * inverseArea;
        const double yx = zy * xz - zz * xy;
        const double yy = zz * xx - zx * xz;
        const double yz = zx * xy - zy * xx;
        out.b11[t] = static_cast<float>(length);
        out.b12[t] = static_cast<float>(xx * bx + xy * by + xz * bz);
        out.b22[t] = static_cast<float>(area * inverseLength);

        // Four times the products of the components of the quaternion with its largest one.
        const double x4 = 1 + xx - yy - zz;
        const double y4 = 1 - xx + yy - zz;
        const double z4 = 1 - xx - yy + zz;
        double largest = 1 + xx + yy + zz;
        double qw = largest;
        double qx = yz - zy;
        double qy = zx - xz;
        double qz = xy - yx;
        const bool byX = x4 > largest;
        largest = byX ? x4 : largest;
        qw = byX ? yz - zy : qw;
        qx = byX ? x4 : qx;
        qy = byX ? xy + yx : qy;
        qz = byX ? zx + xz : qz;
        const bool byY = y4 > largest;
        largest = byY ? y4 : largest;
        qw = byY ? zx - xz : qw;
        qx = byY ? xy + yx : qx;
        qy = byY ? y4 : qy;
        qz = byY ? yz + zy : qz;
        const bool byZ = z4 > largest;
        largest = byZ ? z4 : largest;
        qw = byZ ? xy - yx : qw;
        qx = byZ ? zx + xz : qx;
        qy = byZ ? yz + zy : qy;
        qz = byZ ? z4 : qz;
        const double scale = 0.5 / std::sqrt(largest);
        out.quaternion[0][t] = static_cast<float>(qw * scale);
        out.quaternion[1][t] = static_cast<float>(qx * scale);
        out.quaternion[2][t] = static_cast<float>(qy * scale);
        out.quaternion[3][t] = static_cast<float>(qz * scale);
        out.logArea[t] = logarithm(static_cast<float>(area));
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
