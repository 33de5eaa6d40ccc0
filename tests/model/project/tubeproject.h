// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/store/resultplaces.h"
#include "tests/model/project/quickvariation.h"
#include "tests/model/project/stripproject.h"

#include <cmath>
#include <numbers>

namespace quadrille::test {

inline constexpr int tubeRings = 14;
inline constexpr int tubeSides = 8;

/// A tube that stands and bends to the side; open at both ends.
/// \param phase  of its swaying, radians. \param size  of its swaying.
inline std::string bentTube(double phase, double size)
{
    std::string text;
    Vec3d centre(0, 0.3, 0);
    double angle = 0;
    for (int ring = 0; ring < tubeRings; ++ring) {
        const Vec3d side(std::cos(angle), -std::sin(angle), 0);
        const Vec3d up(std::sin(angle), std::cos(angle), 0);
        for (int s = 0; s < tubeSides; ++s) {
            const double turn = 2 * std::numbers::pi * s / tubeSides;
            const Vec3d p = centre + 0.08 * (std::cos(turn) * side + std::sin(turn) * Vec3d::UnitZ());
            text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
                    "\n";
        }
        centre += 0.1 * up;
        angle += size * std::sin(phase + 0.25 * ring);
    }
    for (int ring = 0; ring + 1 < tubeRings; ++ring) {
        for (int s = 0; s < tubeSides; ++s) {
            const auto corner = [&](int r, int t) {
                return " " + std::to_string((ring + r) * tubeSides + (s + t) % tubeSides + 1);
            };
            text += "f" + corner(0, 0) + corner(1, 0) + corner(1, 1) + "\nf" + corner(0, 0) + corner(1, 1) +
                    corner(0, 1) + "\n";
        }
    }
    return text;
}

inline PartCurveEntry tubeRing(std::string name, int ring)
{
    PartCurveEntry entry;
    entry.curve.name = std::move(name);
    for (int s = 0; s < tubeSides; ++s)
        entry.curve.vertices.emplace_back(ring * tubeSides + s);
    return entry;
}

/// A project of two takes of a swaying tube in two parts, with variations of them.
class TubeProject : public StripProject
{
protected:
    TubeProject()
    {
        write("calm", 18, 0.06);
        write("wild", 15, 0.09);
        project.settings.fps = 10;
        project.sequences = {sequenceOf("calm", "calm"), sequenceOf("wild", "wild")};
        BodyPartsEntry parts;
        parts.curves = {tubeRing("low", 6), tubeRing("high", 8)};
        parts.parts.resize(2);
        parts.parts[0].part = {"base", "", {}};
        parts.parts[1].part = {"tip", "base", {"low", "high"}};
        project.bodyParts = {parts};
        project.variations = {quickVariation("sway", "calm", "wild", 2)};
    }
    void write(const std::string& take, int frames, double size)
    {
        for (int f = 0; f < frames; ++f) {
            const double phase = 2 * std::numbers::pi * f / frames;
            folder.write(take + "/f_" + std::to_string(100 + f) + ".obj", bentTube(phase, size));
        }
    }
    VariationEntry& sway() { return project.variations.front(); }
    MeshSequence opened(const std::string& clip)
    {
        SequenceOpener opener(project, folder.path(), cacheFolder(folder / "p.quadrille"));
        return opener.openClip(clip)->sequence;
    }
};

} // namespace quadrille::test
