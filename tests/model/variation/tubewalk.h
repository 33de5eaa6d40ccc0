// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/model/variation/swayingtakes.h"

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace quadrille::test {

/// How a tube walks.
struct TubeWalk
{
    int frames = 45;
    int period = 20;    ///< of its swaying, frames
    double step = 0.02; ///< metres a frame
    double size = 1;    ///< of its swaying
    double turn = 0;    ///< radians a frame
};

/// Triangles as lines of an OBJ file.
inline std::string facesText(const Topology& topology)
{
    std::string text;
    for (const Triangle& t : topology.triangles())
        text += "f " + std::to_string(t[0].value + 1) + " " + std::to_string(t[1].value + 1) + " " +
                std::to_string(t[2].value + 1) + "\n";
    return text;
}

/// The frames of a tube that sways and walks, each as the text of an OBJ file.
inline std::vector<std::string> walkFiles(const TubeWalk& walk)
{
    const auto phase = [&](int f) { return 2 * std::numbers::pi * f / walk.period; };
    const auto place = [&](int f) -> RigidMotion {
        const double turn = walk.turn * f;
        return {Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vec3d::UnitY())),
                {walk.step * f * std::sin(turn / 2), 0, walk.step * f * std::cos(turn / 2)}};
    };
    const MeshSequence take = swayingTake("walk", walk.frames, phase, place, walk.size);
    std::vector<std::string> files;
    for (int f = 0; f < walk.frames; ++f) {
        std::string& text = files.emplace_back();
        for (const Vec3f& p : take.frame(FrameIndex(f)).positions())
            text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
                    "\n";
        text += facesText(*take.topology);
    }
    return files;
}

/// Makes the folder with the frames in it: f_100.obj, f_101.obj …
inline void writeWalk(const std::filesystem::path& folder, const TubeWalk& walk)
{
    std::filesystem::create_directories(folder);
    const std::vector<std::string> files = walkFiles(walk);
    for (std::size_t f = 0; f < files.size(); ++f)
        std::ofstream(folder / ("f_" + std::to_string(100 + f) + ".obj")) << files[f];
}

} // namespace quadrille::test
