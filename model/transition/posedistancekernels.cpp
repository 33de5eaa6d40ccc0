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

/// What is known of the triangles of a slice in two poses, from sweep to sweep: short sweeps have more
/// triangles on their way at once than a long one, whose chain of roots and polynomials the processor waits
/// for.
struct alignas(64) TrianglePairs
{
    TriangleSlice::Row m12;       ///< of M = B_j·B_i⁻¹, upper triangular
    TriangleSlice::Row trace;     ///< of M
    TriangleSlice::Row plus;      ///< σ₁ + σ₂ of M
    TriangleSlice::Row eccentric; ///< ((σ₁ − σ₂) / (σ₁ + σ₂))²
    TriangleSlice::Row sine2;     ///< of half the angle, squared
    TriangleSlice::Row cosine2;
    TriangleSlice::Row angle; ///< in [0, π]
};

/// M and its singular values. \param inverse11, inverse22  1 / b11 and 1 / b22 of the target.
[[gnu::always_inline]] inline void setShapes(const TriangleSlice& target, const TriangleSlice::Row& inverse11,
                                             const TriangleSlice::Row& inverse22, const TriangleSlice& source,
                                             TrianglePairs& pairs)
{
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        // M = 1 + U: what hardly differs from 1 keeps its precision.
        const float u11 = (source.b11[t] - target.b11[t]) * inverse11[t];
        const float u22 = (source.b22[t] - target.b22[t]) * inverse22[t];
        const float m12 = ((source.b12[t] - target.b12[t]) - u11 * target.b12[t]) * inverse22[t];
        const float trace = 2 + (u11 + u22);
        const float difference = u11 - u22;
        const float plus2 = trace * trace + m12 * m12;
        pairs.m12[t] = m12;
        pairs.trace[t] = trace;
        pairs.plus[t] = std::sqrt(plus2);
        pairs.eccentric[t] = (difference * difference + m12 * m12) / plus2;
    }
}

/// The rotation from q_i to q = turn · q_j · q_z(φ), φ = atan2(−m12, trace), by sine and cosine.
[[gnu::always_inline]] inline void setTurns(const TriangleSlice& target, const TriangleSlice& source,
                                            Quaternion turn, TrianglePairs& pairs)
{
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const Quaternion qi = quaternionOf(target, t);
        const Quaternion q = product(turn, quaternionOf(source, t));
        // g = q̄_i · q, whose vector part q̄_i · (q − q_i) has as well, and more precisely
        const float gw = qi.w * q.w + qi.x * q.x + qi.y * q.y + qi.z * q.z;
        const Quaternion g =
            product({qi.w, -qi.x, -qi.y, -qi.z}, {q.w - qi.w, q.x - qi.x, q.y - qi.y, q.z - qi.z});
        // The half of φ has its cosine and sine along (plus + trace, −m12).
        const float m12 = pairs.m12[t];
        const float c = pairs.plus[t] + pairs.trace[t];
        const float inverseNorm = 1 / (c * c + m12 * m12);
        const float pw = gw * c + g.z * m12;
        const float pz = g.z * c - gw * m12;
        pairs.sine2[t] = g.x * g.x + g.y * g.y + pz * pz * inverseNorm;
        pairs.cosine2[t] = pw * pw * inverseNorm;
    }
}

[[gnu::always_inline]] inline void setAngles(TrianglePairs& pairs)
{
#pragma omp simd
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const float smaller = std::min(pairs.sine2[t], pairs.cosine2[t]);
        const float part = std::sqrt(smaller) * angleOverSine(smaller);
        pairs.angle[t] = pairs.sine2[t] > pairs.cosine2[t] ? pi - part : part;
    }
}

/// Σ θ + w·‖log S‖, where no σ₁ is more than three times σ₂.
/// With d = log σ₁σ₂ and e = ((σ₁ − σ₂)/(σ₁ + σ₂))², ‖log S‖² = ½·d² + 2·atanh²(√e).
/// \param largest  out: the largest e; where it is above ¼ the sum is not to be used.
[[gnu::always_inline]] inline float sumOfModest(const TriangleSlice& target, const TriangleSlice& source,
                                                const TrianglePairs& pairs, float stretchFactor,
                                                float& largest)
{
    float sum = 0;
    float most = 0;
#pragma omp simd reduction(+ : sum) reduction(max : most)
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const float e = pairs.eccentric[t];
        // atanh²(√e) / e for e in [0, ¼], within 1e-8
        float p = 0.6697128135F;
        p = p * e + 0.1556816968F;
        p = p * e + 0.3863918427F;
        p = p * e + 0.4164070668F;
        p = p * e + 0.5112238198F;
        p = p * e + 0.6666648841F;
        p = p * e + 1;
        const float d = source.logArea[t] - target.logArea[t];
        sum += pairs.angle[t] + stretchFactor * std::sqrt(0.5F * d * d + (e + e) * p);
        most = e > most ? e : most;
    }
    largest = most;
    return sum;
}

/// Σ θ + w·‖log S‖ of any triangles.
[[gnu::always_inline]] inline float sumOfAny(const TriangleSlice& target, const TriangleSlice& source,
                                             const TrianglePairs& pairs, float stretchFactor)
{
    float sum = 0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t t = 0; t < sliceTriangles; ++t) {
        const float plus = pairs.plus[t];
        const float log1 = logarithm(0.5F * (plus + plus * std::sqrt(pairs.eccentric[t])));
        const float log2 = (source.logArea[t] - target.logArea[t]) - log1;
        sum += pairs.angle[t] + stretchFactor * std::sqrt(log1 * log1 + log2 * log2);
    }
    return sum;
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
    TrianglePairs pairs;
    for (std::size_t s = 0; s < count; ++s) {
        const TriangleSlice& source = sources[s];
        setShapes(target, inverse11, inverse22, source, pairs);
        setTurns(target, source, {rotations[s][0], rotations[s][1], rotations[s][2], rotations[s][3]}, pairs);
        setAngles(pairs);
        float largest = 0;
        float sum = sumOfModest(target, source, pairs, stretchFactor, largest);
        if (!(largest <= 0.25F))
            sum = sumOfAny(target, source, pairs, stretchFactor);
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
