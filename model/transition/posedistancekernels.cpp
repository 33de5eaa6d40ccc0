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

/// Passed by value: by reference, loops that use it do not vectorise (g++ 12).
struct Quaternion
{
    float w;
    float x;
    float y;
    float z;
};

[[gnu::always_inline]] inline Quaternion product(Quaternion a, Quaternion b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

[[gnu::always_inline]] inline Quaternion quaternionOf(const TriangleSlice& slice, std::size_t t)
{
    return {slice.quaternion[0][t], slice.quaternion[1][t], slice.quaternion[2][t], slice.quaternion[3][t]};
}

/// The rotation from q_i to q · q_z(φ), φ = atan2(−m12, trace), in [0, π].
/// \param plus  √(trace² + m12²).
[[gnu::always_inline]] inline float rotationAngle(Quaternion qi, Quaternion q, float trace, float m12,
                                                  float plus)
{
    // g = q̄_i · q, whose vector part q̄_i · (q − q_i) has as well, and more precisely
    const float gw = qi.w * q.w + qi.x * q.x + qi.y * q.y + qi.z * q.z;
    const Quaternion g =
        product({qi.w, -qi.x, -qi.y, -qi.z}, {q.w - qi.w, q.x - qi.x, q.y - qi.y, q.z - qi.z});
    // The half of φ has its cosine and sine along (plus + trace, −m12).
    const float c = plus + trace;
    const float inverseNorm = 1 / (c * c + m12 * m12);
    const float pw = gw * c + g.z * m12;
    const float pz = g.z * c - gw * m12;
    const float sine2 = g.x * g.x + g.y * g.y + pz * pz * inverseNorm; // of half the angle, squared
    const float cosine2 = pw * pw * inverseNorm;
    const float smaller = std::min(sine2, cosine2);
    const float part = std::sqrt(smaller) * angleOverSine(smaller);
    return sine2 > cosine2 ? pi - part : part;
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
    for (std::size_t s = 0; s < count; ++s) {
        const TriangleSlice& source = sources[s];
        const Quaternion turn{rotations[s][0], rotations[s][1], rotations[s][2], rotations[s][3]};
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
            const float angle = rotationAngle(quaternionOf(target, t), product(turn, quaternionOf(source, t)),
                                              trace, m12, plus);
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
    const auto& a = target.coordinates;
    for (std::size_t s = 0; s < count; ++s) {
        const auto& b = sources[s].coordinates;
        const float w = rotations[s][0];
        const float x = rotations[s][1];
        const float y = rotations[s][2];
        const float z = rotations[s][3];
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
            const float dx = a[0][v] - (r11 * b[0][v] + r12 * b[1][v] + r13 * b[2][v]);
            const float dy = a[1][v] - (r21 * b[0][v] + r22 * b[1][v] + r23 * b[2][v]);
            const float dz = a[2][v] - (r31 * b[0][v] + r32 * b[1][v] + r33 * b[2][v]);
            sum += std::sqrt(dx * dx + dy * dy + dz * dz);
        }
        sums[s] += double{sum};
    }
}

} // namespace quadrille
