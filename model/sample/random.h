// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace quadrille {

/// Random numbers that are the same with every compiler and library (SplitMix64).
class SampleRandom
{
public:
    explicit SampleRandom(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next()
    {
        m_state += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    /// Uniform in [low, high).
    double between(double low, double high) { return low + (high - low) * unit(); }

private:
    std::uint64_t m_state;
};

/// A value in [0, 1) that belongs to a cell of an integer lattice.
inline double latticeValue(int x, int y, int z, std::uint64_t seed)
{
    std::uint64_t key = seed;
    for (const int c : {x, y, z})
        key = key * 0x100000001b3ULL ^ static_cast<std::uint32_t>(c);
    return SampleRandom(key).unit();
}

/// Smooth value noise in [−1, 1] with a wavelength of about two units.
inline double valueNoise(double x, double y, double z, std::uint64_t seed)
{
    const double fx = std::floor(x);
    const double fy = std::floor(y);
    const double fz = std::floor(z);
    const auto ease = [](double t) { return t * t * (3 - 2 * t); };
    const double tx = ease(x - fx);
    const double ty = ease(y - fy);
    const double tz = ease(z - fz);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1;
        const int j = (corner >> 1) & 1;
        const int k = corner >> 2;
        const double weight = (i ? tx : 1 - tx) * (j ? ty : 1 - ty) * (k ? tz : 1 - tz);
        sum += weight * latticeValue(static_cast<int>(fx) + i, static_cast<int>(fy) + j,
                                     static_cast<int>(fz) + k, seed);
    }
    return 2 * sum - 1;
}

} // namespace quadrille
