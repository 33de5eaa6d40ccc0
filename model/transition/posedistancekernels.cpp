// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/posedistancekernels.h"

#include "model/core/simd.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace quadrille {

namespace {

/// Natural logarithm of a positive number, 1e-7 of the larger of 1 and the result; log(1) = 0 exactly.
[[gnu::always_inline]] inline float logarithm(float x)
{
    // x = m · 2^e with m in [√½, √2)
    constexpr std::int32_t rootOfHalf = 0x3F35'04F3;
    const auto bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits - rootOfHalf) >> 23;
    const float f = std::bit_cast<float>(bits - exponent * (1 << 23)) - 1;
    float p = 0.087872654911F;
    p = p * f - 0.1415964701F;
    p = p * f + 0.14834786839F;
    p = p * f - 0.16588488532F;
    p = p * f + 0.1997204971F;
    p = p * f - 0.25001147678F;
    p = p * f + 0.3333367061F;
    p = p * f - 0.49999997133F;
    return f + f * f * p + static_cast<float>(exponent) * 0.69314718056F;
}

/// 4·asin(½·√y) / √y for y in [0, 2], within 6e-8.
[[gnu::always_inline]] inline float angleOverChord(float y)
{
    float p = 1.0290307852e-5F;
    p = p * y - 2.3249388561e-5F;
    p = p * y + 9.3513262654e-5F;
    p = p * y + 0.00019960033746F;
    p = p * y + 0.0014082654112F;
    p = p * y + 0.0093733145791F;
    p = p * y + 0.083333367883F;
    return p * y + 2;
}

} // namespace

QUADRILLE_SIMD_CLONES
void addSurfaceDistances(const TriangleSlice& target, const TriangleSlice* sources,
                         const RotationF* rotations, std::size_t count, float stretchWeight, double* sums)
{
    alignas(64) TriangleSlice::Row inverse11;
    alignas(64) TriangleSlice::Row inverse22;
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        inverse11[t] = 1 / target.b11[t];
        inverse22[t] = 1 / target.b22[t];
    }
    const float stretchFactor = stretchWeight * 0.70710678F;
    const auto& [aw, ax, ay, az] = target.quaternion;
    for (std::size_t s = 0; s < count; ++s) {
        const TriangleSlice& source = sources[s];
        const auto& [bw, bx, by, bz] = source.quaternion;
        const auto [rw, rx, ry, rz] = rotations[s];
        float sum = 0;
#pragma omp simd reduction(+ : sum)
        for (std::size_t t = 0; t < sliceTriangles; ++t) {
            // B_j·B_i⁻¹ = 1 + U, upper triangular; its parts that hardly differ from 1 keep their precision
            const float u11 = (source.b11[t] - target.b11[t]) * inverse11[t];
            const float u22 = (source.b22[t] - target.b22[t]) * inverse22[t];
            const float m12 = ((source.b12[t] - target.b12[t]) - u11 * target.b12[t]) * inverse22[t];
            // σ₁ + σ₂ and σ₁ − σ₂, and the polar angle φ = atan2(−m12, m11 + m22)
            const float trace = 2 + (u11 + u22);
            const float difference = u11 - u22;
            const float plusSquared = trace * trace + m12 * m12;
            const float inversePlus = 1 / std::sqrt(plusSquared);
            const float minus = std::sqrt(difference * difference + m12 * m12);
            const float cosine2 = 0.5F + 0.5F * (trace * inversePlus); // of φ/2, squared
            const float inverseCosine = 1 / std::sqrt(cosine2);
            const float c = cosine2 * inverseCosine;
            const float z = -0.5F * (m12 * inversePlus) * inverseCosine;
            // q = q_Q · q_j · q_z(φ)
            const float pw = bw[t] * c - bz[t] * z;
            const float px = bx[t] * c + by[t] * z;
            const float py = by[t] * c - bx[t] * z;
            const float pz = bz[t] * c + bw[t] * z;
            const float qw = rw * pw - rx * px - ry * py - rz * pz;
            const float qx = rw * px + rx * pw + ry * pz - rz * py;
            const float qy = rw * py - rx * pz + ry * pw + rz * px;
            const float qz = rw * pz + rx * py - ry * px + rz * pw;
            // the chord from q_i to the nearer of ±q
            const float sign = std::copysign(1.0F, aw[t] * qw + ax[t] * qx + ay[t] * qy + az[t] * qz);
            const float dw = aw[t] - sign * qw;
            const float dx = ax[t] - sign * qx;
            const float dy = ay[t] - sign * qy;
            const float dz = az[t] - sign * qz;
            const float chord2 = dw * dw + dx * dx + dy * dy + dz * dz;
            const float angle = std::sqrt(chord2) * angleOverChord(chord2);

            const float log1 = logarithm(0.5F * (plusSquared * inversePlus + minus));
            const float log2 = logarithm((1 + u11) * (1 + u22)) - log1;
            sum += angle + stretchFactor * std::sqrt(log1 * log1 + log2 * log2);
        }
        sums[s] += double{sum};
    }
}

QUADRILLE_SIMD_CLONES
void addEuclideanDistances(const VertexSlice& target, const VertexSlice* sources, const RotationF* rotations,
                           std::size_t count, double* sums)
{
    const auto& [ax, ay, az] = target.coordinates;
    for (std::size_t s = 0; s < count; ++s) {
        const auto& [bx, by, bz] = sources[s].coordinates;
        const auto [w, x, y, z] = rotations[s];
        const float r11 = 1 - 2 * (y * y + z * z);
        const float r12 = 2 * (x * y - w * z);
        const float r13 = 2 * (x * z + w * y);
        const float r21 = 2 * (x * y + w * z);
        const float r22 = 1 - 2 * (x * x + z * z);
        const float r23 = 2 * (y * z - w * x);
        const float r31 = 2 * (x * z - w * y);
        const float r32 = 2 * (y * z + w * x);
        const float r33 = 1 - 2 * (x * x + y * y);
        float sum = 0;
#pragma omp simd reduction(+ : sum)
        for (std::size_t v = 0; v < sliceVertices; ++v) {
            const float dx = ax[v] - (r11 * bx[v] + r12 * by[v] + r13 * bz[v]);
            const float dy = ay[v] - (r21 * bx[v] + r22 * by[v] + r23 * bz[v]);
            const float dz = az[v] - (r31 * bx[v] + r32 * by[v] + r33 * bz[v]);
            sum += std::sqrt(dx * dx + dy * dy + dz * dz);
        }
        sums[s] += double{sum};
    }
}

} // namespace quadrille
