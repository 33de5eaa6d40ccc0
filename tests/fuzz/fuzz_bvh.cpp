// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/sequence/io/bvh.h"

using namespace quadrille;

/// Anything but a skeleton or an Error is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        const Bvh bvh = parseBvh({reinterpret_cast<const char*>(data), size}, "fuzz.bvh");
        const JointAngles angles = jointAngles(bvh);
        if (angles.frameCount < 1000)
            resampled(angles, angles.fps / 2, 0, (angles.frameCount + 1) / 2);
    } catch (const Error&) {
    }
    return 0;
}
