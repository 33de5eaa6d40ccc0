// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/framemeasures.h"

#include "model/geometry/procrustes.h"

#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

double rmsAcceleration(Positions before, Positions now, Positions after, double fps)
{
    double sum = 0;
    for (std::size_t v = 0; v < now.size(); ++v)
        sum += (before[v].cast<double>() - 2 * now[v].cast<double>() + after[v].cast<double>()).squaredNorm();
    return std::sqrt(sum / static_cast<double>(now.size())) * fps * fps;
}

double meanStep(Positions from, Positions to)
{
    double sum = 0;
    for (std::size_t v = 0; v < from.size(); ++v)
        sum += (to[v] - from[v]).cast<double>().norm();
    return sum / static_cast<double>(from.size());
}

double enclosedVolume(Positions positions, std::span<const Triangle> triangles)
{
    const Vec3d centre = centroid(positions);
    double sum = 0;
    for (const Triangle& triangle : triangles) {
        const auto corner = [&](std::size_t c) -> Vec3d {
            return positions[triangle[c].value].cast<double>() - centre;
        };
        sum += corner(0).dot(corner(1).cross(corner(2)));
    }
    return sum / 6;
}

double meanSlip(Positions from, Positions to, std::span<const std::uint32_t> vertices, const Ground& ground)
{
    double sum = 0;
    for (const std::uint32_t v : vertices)
        sum += ground.of((to[v] - from[v]).cast<double>()).norm();
    return sum / static_cast<double>(vertices.size());
}

std::vector<FrameMeasure> frameMeasures(const CharacterFrames& character, std::span<const Support> supports,
                                        UpAxis up, const Progress& progress)
{
    const Ground ground(up);
    const FrameLayout& layout = character.layout();
    std::vector<FrameMeasure> measures(static_cast<std::size_t>(character.frameCount()));
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(0, character.frameCount(), [&](NodeIndex node) {
        FrameMeasure& measure = measures[static_cast<std::size_t>(node)];
        const int sequence = layout.sequenceOf(node);
        const double fps = character.sequences()[static_cast<std::size_t>(sequence)].fps;
        const Frame now = character.frame(node);
        measure.volume = enclosedVolume(now.positions(), character.triangles());
        if (node < layout.lastOf(sequence)) {
            const Frame after = character.frame(node + 1);
            if (node > layout.firstOf(sequence))
                measure.acceleration = rmsAcceleration(character.frame(node - 1).positions(), now.positions(),
                                                       after.positions(), fps);
            const std::vector<std::uint32_t> both =
                supports.empty() ? std::vector<std::uint32_t>()
                                 : common(supports[static_cast<std::size_t>(node)].vertices,
                                          supports[static_cast<std::size_t>(node) + 1].vertices);
            if (!both.empty())
                measure.slip = fps * meanSlip(now.positions(), after.positions(), both, ground);
        }
        progress.report(++done, std::int64_t{character.frameCount()});
    });
    return measures;
}

} // namespace quadrille
