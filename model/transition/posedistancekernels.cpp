// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/posedistancekernels.h"

#include "model/core/simd.h"
#include "model/core/simdmath.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// 2·asin(√u) / √u for u in [0, ½], within 6e-8.
[[gnu::always_inline]] inline float angleOverSine(float u)
{
    float p = 0.1685964038F;
    p = p * u - 0.09522949555F;
    p = p * u + 0.09575758096F;
    p = p * u + 0.05109768639F;
    p = p * u + 0.09012898632F;
    p = p * u + 0.1499730333F;
    p = p * u + 0.3333334715F;
    return p * u + 2;
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
            // B_j·B_i⁻¹ = 1 + U, upper triangular: what hardly differs from 1 keeps its precision.
            const float u11 = (source.b11[t] - target.b11[t]) * inverse11[t];
            const float u22 = (source.b22[t] - target.b22[t]) * inverse22[t];
            const float m12 = ((source.b12[t] - target.b12[t]) - u11 * target.b12[t]) * inverse22[t];
            const float trace = 2 + (u11 + u22);
            const float difference = u11 - u22;
            const float plus = std::sqrt(trace * trace + m12 * m12);            // σ₁ + σ₂
            const float minus = std::sqrt(difference * difference + m12 * m12); // σ₁ − σ₂
            // q = q_Q · q_j and g = q̄_i · q, whose vector part q̄_i · (q − q_i) has as well, and more
            // precisely
            const float qw = rw * bw[t] - rx * bx[t] - ry * by[t] - rz * bz[t];
            const float qx = rw * bx[t] + rx * bw[t] + ry * bz[t] - rz * by[t];
            const float qy = rw * by[t] - rx * bz[t] + ry * bw[t] + rz * bx[t];
            const float qz = rw * bz[t] + rx * by[t] - ry * bx[t] + rz * bw[t];
            const float dw = qw - aw[t];
            const float dx = qx - ax[t];
            const float dy = qy - ay[t];
            const float dz = qz - az[t];
            const float gw = aw[t] * qw + ax[t] * qx + ay[t] * qy + az[t] * qz;
            const float gx = aw[t] * dx - ax[t] * dw - ay[t] * dz + az[t] * dy;
            const float gy = aw[t] * dy + ax[t] * dz - ay[t] * dw - az[t] * dx;
            const float gz = aw[t] * dz - ax[t] * dy + ay[t] * dx - az[t] * dw;
            // g·q_z(φ) with φ = atan2(−m12, trace), whose half has cosine and sine along (plus + trace, −m12)
            const float c = plus + trace;
            const float inverseNorm = 1 / (c * c + m12 * m12);
            const float pw = gw * c + gz * m12;
            const float pz = gz * c - gw * m12;
            const float sine2 = gx * gx + gy * gy + pz * pz * inverseNorm; // of θ/2, squared
            const float cosine2 = pw * pw * inverseNorm;
            const float smaller = std::min(sine2, cosine2);
            const float part = std::sqrt(smaller) * angleOverSine(smaller);
            const float angle = sine2 > cosine2 ? pi - part : part;

            const float log1 = logarithm(0.5F * (plus + minus));
            const float log2 = (source.logArea[t] - target.logArea[t]) - log1;
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
