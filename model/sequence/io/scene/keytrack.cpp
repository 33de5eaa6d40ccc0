// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/keytrack.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr double keyTolerance = 1e-5;

/// The keys before and after a time and how far it is from one to the other.
struct KeySpan
{
    std::size_t before;
    std::size_t after;
    double weight;
    double seconds; ///< from one to the other
};

KeySpan findKeys(const std::vector<double>& times, double seconds)
{
    const auto next = std::upper_bound(times.begin(), times.end(), seconds + keyTolerance);
    const auto after = static_cast<std::size_t>(next - times.begin());
    if (after == 0)
        return {0, 0, 0, 0};
    if (after == times.size())
        return {after - 1, after - 1, 0, 0};
    const double length = times[after] - times[after - 1];
    const double passed = seconds - times[after - 1];
    return {after - 1, after, passed < keyTolerance ? 0.0 : std::min(passed / length, 1.0), length};
}

/// glTF 2.0, appendix C: cubic spline interpolation.
double cubic(double from, double outTangent, double to, double inTangent, double t, double length)
{
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * from + length * (t3 - 2 * t2 + t) * outTangent + (3 * t2 - 2 * t3) * to +
           length * (t3 - t2) * inTangent;
}

} // namespace

void evaluate(const KeyTrack& track, double seconds, std::span<double> out)
{
    const KeySpan keys = findKeys(track.times, seconds);
    const std::size_t components = out.size();
    const auto value = [&](std::size_t row, std::size_t c) {
        return static_cast<double>(track.values[row * components + c]);
    };
    for (std::size_t c = 0; c < components; ++c) {
        switch (track.interpolation) {
        case KeyInterpolation::Step:
            out[c] = value(keys.before, c);
            break;
        case KeyInterpolation::Linear:
            out[c] = value(keys.before, c) + keys.weight * (value(keys.after, c) - value(keys.before, c));
            break;
        case KeyInterpolation::CubicSpline:
            out[c] = cubic(value(keys.before * 3 + 1, c), value(keys.before * 3 + 2, c),
                           value(keys.after * 3 + 1, c), value(keys.after * 3, c), keys.weight, keys.seconds);
            break;
        }
    }
}

Eigen::Quaterniond evaluateRotation(const KeyTrack& track, double seconds)
{
    std::array<double, 4> q{};
    if (track.interpolation != KeyInterpolation::Linear) {
        evaluate(track, seconds, q);
        return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized();
    }
    const KeySpan keys = findKeys(track.times, seconds);
    const auto rotation = [&](std::size_t key) {
        const float* v = track.values.data() + key * 4;
        return Eigen::Quaterniond(v[3], v[0], v[1], v[2]).normalized();
    };
    return rotation(keys.before).slerp(keys.weight, rotation(keys.after)).normalized();
}

} // namespace quadrille
