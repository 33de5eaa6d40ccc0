// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sample/sample.h"

namespace quadrille {

/// The whole sample with a small texture, made once for all tests of the program.
inline const SampleCharacter& smallSample()
{
    static const SampleCharacter character = makeSampleCharacter({.textureSize = 128});
    return character;
}

inline double signedVolume(const Topology& topology, Positions positions)
{
    double volume = 0;
    for (const Triangle& t : topology.triangles()) {
        const Vec3d a = positions[t[0].value].cast<double>();
        const Vec3d b = positions[t[1].value].cast<double>();
        const Vec3d c = positions[t[2].value].cast<double>();
        volume += a.dot(b.cross(c)) / 6;
    }
    return volume;
}

} // namespace quadrille
