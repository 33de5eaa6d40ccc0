// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace quadrille::test {

/// A motion of one joint that stands still, as BVH. \param frameTime  as it is written.
inline std::string oneJointBvh(int frames, const std::string& frameTime)
{
    std::string text = "HIERARCHY\nROOT hip\n{\n  OFFSET 0 0 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
                       "  End Site\n  {\n    OFFSET 0 1 0\n  }\n}\nMOTION\nFrames: " +
                       std::to_string(frames) + "\nFrame Time: " + frameTime + "\n";
    for (int f = 0; f < frames; ++f)
        text += "0 0 0\n";
    return text;
}

} // namespace quadrille::test
