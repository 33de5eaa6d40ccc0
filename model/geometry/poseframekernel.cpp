// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/poseframekernel.h"

#include "model/core/simd.h"

#include <cmath>

namespace quadrille {

QUADRILLE_SIMD_CLONES void computeFrames(FrameBlock& block, double least)
{
    for (std::size_t i = 0; i < frameBlockSize; ++i) {
        const double ax = block.first[0][i];
        const double ay = block.first[1][i];
        const double az = block.first[2][i];
        const double bx = block.second[0][i];
        const double by = block.second[1][i];
        const double bz = block.second[2][i];
        double zx = ay * bz - az * by;
        double zy = az * bx - ax * bz;
        double zz = ax * by - ay * bx;
        const double length = std::sqrt(ax * ax + ay * ay + az * az);
        const double area = std::sqrt(zx * zx + zy * zy + zz * zz);
        const bool valid = area >= least;
        const double perLength = 1.0 / length;
        const double perArea = 1.0 / area;
        const double xx = ax * perLength;
        const double xy = ay * perLength;
        const double xz = az * perLength;
        zx *= perArea;
        zy *= perArea;
        zz *= perArea;
        const double yx = zy * xz - zz * xy;
        const double yy = zz * xx - zx * xz;
        const double yz = zx * xy - zy * xx;
        // The largest of the four components is found first; the others follow from it.
        const double w4 = 1 + xx + yy + zz;
        const double x4 = 1 + xx - yy - zz;
        const double y4 = 1 - xx + yy - zz;
        const double z4 = 1 - xx - yy + zz;
        double largest = w4;
        double w = w4;
        double x = yz - zy;
        double y = zx - xz;
        double z = xy - yx;
        const bool byX = x4 > largest;
        largest = byX ? x4 : largest;
        w = byX ? yz - zy : w;
        x = byX ? x4 : x;
        y = byX ? xy + yx : y;
        z = byX ? zx + xz : z;
        const bool byY = y4 > largest;
        largest = byY ? y4 : largest;
        w = byY ? zx - xz : w;
        x = byY ? xy + yx : x;
        y = byY ? y4 : y;
        z = byY ? yz + zy : z;
        const bool byZ = z4 > largest;
        largest = byZ ? z4 : largest;
        w = byZ ? xy - yx : w;
        x = byZ ? zx + xz : x;
        y = byZ ? yz + zy : y;
        z = byZ ? z4 : z;
        const double scale = 0.5 / std::sqrt(largest);
        block.quaternion[0][i] = valid ? w * scale : 1.0;
        block.quaternion[1][i] = valid ? x * scale : 0.0;
        block.quaternion[2][i] = valid ? y * scale : 0.0;
        block.quaternion[3][i] = valid ? z * scale : 0.0;
        block.edges[0][i] = valid ? length : 1.0;
        block.edges[1][i] = valid ? xx * bx + xy * by + xz * bz : 0.0;
        block.edges[2][i] = valid ? area * perLength : 1.0;
        block.doubleArea[i] = area;
    }
}

} // namespace quadrille
