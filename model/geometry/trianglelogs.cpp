// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/trianglelogs.h"

#include "model/core/simd.h"

#include <array>
#include <cmath>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
// The C library has these for whole vectors, but says so only under -ffast-math.
#define QUADRILLE_VECTOR_MATH noexcept __attribute__((simd("notinbranch")))
extern "C" {
double atan2(double, double) QUADRILLE_VECTOR_MATH;
double exp(double) QUADRILLE_VECTOR_MATH;
double log(double) QUADRILLE_VECTOR_MATH;
double sin(double) QUADRILLE_VECTOR_MATH;
}
#undef QUADRILLE_VECTOR_MATH
#endif

namespace quadrille {

namespace {

QUADRILLE_SIMD_CLONES void fillLogs(const PoseFrames& source, const PoseFrames& target, double tw, double tx,
                                    double ty, double tz, TriangleLogs& logs)
{
    const std::size_t count = source.size();
    const double* const aw = source.qw.data();
    const double* const ax = source.qx.data();
    const double* const ay = source.qy.data();
    const double* const az = source.qz.data();
    const double* const a11 = source.b11.data();
    const double* const a12 = source.b12.data();
    const double* const a22 = source.b22.data();
    const double* const bw = target.qw.data();
    const double* const bx = target.qx.data();
    const double* const by = target.qy.data();
    const double* const bz = target.qz.data();
    const double* const b11 = target.b11.data();
    const double* const b12 = target.b12.data();
    const double* const b22 = target.b22.data();
    double* const axisX = logs.axisX.data();
    double* const axisY = logs.axisY.data();
    double* const axisZ = logs.axisZ.data();
    double* const halfAngle = logs.halfAngle.data();
    double* const cosine = logs.cosine.data();
    double* const logScale = logs.logScale.data();
    double* const logStretch = logs.logStretch.data();
    double* const u1 = logs.u1.data();
    double* const u2 = logs.u2.data();
#pragma GCC ivdep
    for (std::size_t m = 0; m < count; ++m) {
        // M = B_target · B_source⁻¹ = Rφ·S in the plane.
        const double m11 = b11[m] / a11[m];
        const double m22 = b22[m] / a22[m];
        const double m12 = (b12[m] - m11 * a12[m]) / a22[m];
        const double trace = std::sqrt((m11 + m22) * (m11 + m22) + m12 * m12);
        const double c = (m11 + m22) / trace;
        const double s = -m12 / trace;
        const double deviation = 0.5 * std::sqrt((m11 - m22) * (m11 - m22) + m12 * m12);
        const double perDeviation = deviation > 1e-15 * trace ? 1 / deviation : 0.0;
        u1[m] = 0.5 * (c * (m11 - m22) + s * m12) * perDeviation;
        u2[m] = (c * m12 + s * m22) * perDeviation;
        const double scale = 0.5 * log(m11 * m22);
        logScale[m] = scale;
        logStretch[m] = log(0.5 * trace + deviation) - scale;

        // q = conj(turn) · q_target · qz(φ) · conj(q_source)
        const double ch = std::sqrt(0.5 * (1 + c));
        const double sh = 0.5 * s / ch;
        const double gw = tw * bw[m] + tx * bx[m] + ty * by[m] + tz * bz[m];
        const double gx = tw * bx[m] - tx * bw[m] - ty * bz[m] + tz * by[m];
        const double gy = tw * by[m] + tx * bz[m] - ty * bw[m] - tz * bx[m];
        const double gz = tw * bz[m] - tx * by[m] + ty * bx[m] - tz * bw[m];
        const double hw = gw * ch - gz * sh;
        const double hx = gx * ch + gy * sh;
        const double hy = gy * ch - gx * sh;
        const double hz = gz * ch + gw * sh;
        const double w = hw * aw[m] + hx * ax[m] + hy * ay[m] + hz * az[m];
        const double x = -hw * ax[m] + hx * aw[m] - hy * az[m] + hz * ay[m];
        const double y = -hw * ay[m] + hx * az[m] + hy * aw[m] - hz * ax[m];
        const double z = -hw * az[m] - hx * ay[m] + hy * ax[m] + hz * aw[m];
        const double length = std::sqrt(x * x + y * y + z * z);
        const double perLength = length > 1e-150 ? (w < 0 ? -1 : 1) / length : 0.0;
        axisX[m] = x * perLength;
        axisY[m] = y * perLength;
        axisZ[m] = z * perLength;
        cosine[m] = std::abs(w);
        halfAngle[m] = atan2(length, std::abs(w));
    }
}

constexpr std::size_t blockSize = 64;
using Block = std::array<std::array<double, blockSize>, 6>;

/// \param linear  0 for the geodesic stretch, 1 for the linear one.
QUADRILLE_SIMD_CLONES void deformBlocks(const PoseFrames& source, const TriangleLogs& logs, double lambda,
                                        bool linear, TriangleEdges* out)
{
    const std::size_t count = source.size();
    const double exponent = linear ? 1.0 : lambda;
    const double rest = linear ? 1 - lambda : 0.0;
    const double part = linear ? lambda : 1.0;
    Block block;
    for (std::size_t from = 0; from < count; from += blockSize) {
        const std::size_t size = count - from < blockSize ? count - from : blockSize;
        const double* const aw = source.qw.data() + from;
        const double* const ax = source.qx.data() + from;
        const double* const ay = source.qy.data() + from;
        const double* const az = source.qz.data() + from;
        const double* const a11 = source.b11.data() + from;
        const double* const a12 = source.b12.data() + from;
        const double* const a22 = source.b22.data() + from;
        const double* const axisX = logs.axisX.data() + from;
        const double* const axisY = logs.axisY.data() + from;
        const double* const axisZ = logs.axisZ.data() + from;
        const double* const halfAngle = logs.halfAngle.data() + from;
        const double* const logScale = logs.logScale.data() + from;
        const double* const logStretch = logs.logStretch.data() + from;
        const double* const u1 = logs.u1.data() + from;
        const double* const u2 = logs.u2.data() + from;
#pragma GCC ivdep
        for (std::size_t i = 0; i < size; ++i) {
            // The stretch at λ is a·I + b·U.
            const double scale = 0.5 * exp(exponent * logScale[i]);
            const double stretch = exp(exponent * logStretch[i]);
            const double a = rest + part * scale * (stretch + 1 / stretch);
            const double b = part * scale * (stretch - 1 / stretch);
            const double s11 = a + b * u1[i];
            const double s12 = b * u2[i];
            const double s22 = a - b * u1[i];
            const double e1x = s11 * a11[i];
            const double e1y = s12 * a11[i];
            const double e2x = s11 * a12[i] + s12 * a22[i];
            const double e2y = s12 * a12[i] + s22 * a22[i];
            // q = exp(λ·log R) · q_source
            // One sine serves both functions (of at most 180 degrees); a pair of calls would not vectorise.
            const double halved = sin(0.5 * lambda * halfAngle[i]);
            const double rw = 1 - 2 * halved * halved;
            const double sine = 2 * halved * std::sqrt(1 - halved * halved);
            const double rx = sine * axisX[i];
            const double ry = sine * axisY[i];
            const double rz = sine * axisZ[i];
            const double w = rw * aw[i] - rx * ax[i] - ry * ay[i] - rz * az[i];
            const double x = rw * ax[i] + rx * aw[i] + ry * az[i] - rz * ay[i];
            const double y = rw * ay[i] - rx * az[i] + ry * aw[i] + rz * ax[i];
            const double z = rw * az[i] + rx * ay[i] - ry * ax[i] + rz * aw[i];
            const double xx = 1 - 2 * (y * y + z * z);
            const double xy = 2 * (x * y + w * z);
            const double xz = 2 * (x * z - w * y);
            const double yx = 2 * (x * y - w * z);
            const double yy = 1 - 2 * (x * x + z * z);
            const double yz = 2 * (y * z + w * x);
            block[0][i] = xx * e1x + yx * e1y;
            block[1][i] = xy * e1x + yy * e1y;
            block[2][i] = xz * e1x + yz * e1y;
            block[3][i] = xx * e2x + yx * e2y;
            block[4][i] = xy * e2x + yy * e2y;
            block[5][i] = xz * e2x + yz * e2y;
        }
        for (std::size_t i = 0; i < size; ++i) {
            out[from + i].first = {block[0][i], block[1][i], block[2][i], 0.0};
            out[from + i].second = {block[3][i], block[4][i], block[5][i], 0.0};
        }
    }
}

} // namespace

TriangleLogs triangleLogs(const PoseFrames& source, const PoseFrames& target,
                          const Eigen::Quaterniond& targetRotation)
{
    TriangleLogs logs;
    for (std::vector<double>* values : {&logs.axisX, &logs.axisY, &logs.axisZ, &logs.halfAngle, &logs.cosine,
                                        &logs.logScale, &logs.logStretch, &logs.u1, &logs.u2})
        values->resize(source.size());
    fillLogs(source, target, targetRotation.w(), targetRotation.x(), targetRotation.y(), targetRotation.z(),
             logs);
    return logs;
}

void deformEdges(const PoseFrames& source, const TriangleLogs& logs, double lambda, StretchPath path,
                 std::span<TriangleEdges> out)
{
    deformBlocks(source, logs, lambda, path == StretchPath::Linear, out.data());
}

} // namespace quadrille
