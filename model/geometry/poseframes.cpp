// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/poseframes.h"

#include "model/core/simd.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr std::size_t blockSize = 64;

/// Of some triangles: the two edges in, the frame out.
struct Block
{
    std::array<std::array<double, blockSize>, 3> first;
    std::array<std::array<double, blockSize>, 3> second;
    std::array<std::array<double, blockSize>, 4> quaternion;
    std::array<std::array<double, blockSize>, 3> edges;
    std::array<double, blockSize> doubleArea;
};

/// \param least  twice the area from which a triangle counts.
QUADRILLE_SIMD_CLONES void computeBlock(Block& block, double least)
{
    for (std::size_t i = 0; i < blockSize; ++i) {
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

} // namespace

PoseFrames poseFrames(std::span<const Triangle> triangles, Positions positions)
{
    Eigen::AlignedBox<double, 3> box;
    for (const Vec3f& position : positions)
        box.extend(position.cast<double>());
    const double least = std::max(2e-12 * box.diagonal().squaredNorm(), 1e-300);

    PoseFrames frames;
    const std::array targets{&frames.qw,  &frames.qx,  &frames.qy, &frames.qz,
                             &frames.b11, &frames.b12, &frames.b22};
    for (std::vector<double>* target : targets)
        target->resize(triangles.size());
    Block block{};
    for (std::size_t from = 0; from < triangles.size(); from += blockSize) {
        const std::size_t count = std::min(blockSize, triangles.size() - from);
        for (std::size_t i = 0; i < count; ++i) {
            const auto& [v1, v2, v3] = triangles[from + i];
            const Vec3d third = positions[v3.value].cast<double>();
            const Vec3d first = positions[v1.value].cast<double>() - third;
            const Vec3d second = positions[v2.value].cast<double>() - third;
            for (std::size_t c = 0; c < 3; ++c) {
                block.first[c][i] = first[static_cast<Eigen::Index>(c)];
                block.second[c][i] = second[static_cast<Eigen::Index>(c)];
            }
        }
        computeBlock(block, least);
        const auto offset = static_cast<std::ptrdiff_t>(from);
        for (std::size_t t = 0; t < targets.size(); ++t) {
            const auto& values = t < 4 ? block.quaternion[t] : block.edges[t - 4];
            std::copy_n(values.begin(), count, targets[t]->begin() + offset);
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!(block.doubleArea[i] >= least))
                frames.degenerate.push_back(static_cast<int>(from + i));
        }
    }
    return frames;
}

} // namespace quadrille
