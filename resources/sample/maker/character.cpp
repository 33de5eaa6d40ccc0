// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/character.h"

#include <algorithm>

namespace quadrille {

Proportions targetProportions()
{
    return {.legs = 0.86,
            .torso = 0.98,
            .arms = 0.95,
            .head = 1.06,
            .shoulders = 1.12,
            .girth = 1.22,
            .belly = 0.05};
}

Palette targetPalette()
{
    Palette palette;
    palette.shirt = {0.62, 0.25, 0.28};
    palette.trim = {0.90, 0.84, 0.70};
    palette.print = {0.93, 0.66, 0.24};
    palette.trousers = {0.40, 0.35, 0.28};
    palette.thread = {0.72, 0.64, 0.50};
    palette.belt = {0.16, 0.13, 0.12};
    palette.shoes = {0.24, 0.36, 0.56};
    palette.skin = {0.55, 0.37, 0.27};
    palette.lips = {0.47, 0.26, 0.23};
    palette.hair = {0.085, 0.07, 0.065};
    palette.iris = {0.26, 0.16, 0.09};
    palette.seed = 19;
    return palette;
}

EdgeLength edgeLengthFor(const Body& body, double scale)
{
    const BodyJoints joints = body.joints();
    return [&body, joints, scale](const Vec3d& point) {
        const Vec3d p(std::abs(point.x()), point.y(), point.z());
        double length = 0.041;
        // \param growth of the length per metre away from the feature.
        const auto finer = [&](double distance, double near, double growth) {
            length = std::min(length, near + growth * std::max(distance, 0.0));
        };
        const Vec3d head = body.toReference(p, FigurePart::Head);
        finer(ellipsoidDistance(head, {0, 1.59, 0.085}, {0.05, 0.062, 0.045}), 0.0098, 0.20);
        finer(ellipsoidDistance(head, {0, 1.64, 0}, {0.09, 0.11, 0.11}), 0.0170, 0.20);
        finer(sphereDistance(head, {0.084, 1.602, -0.006}, 0.03), 0.0120, 0.20);
        finer(taperedCapsuleDistance(p, joints.wrist, joints.fingertips, 0.03, 0.07), 0.0080, 0.22);
        finer(taperedCapsuleDistance(p, joints.ankle, joints.toeTip, 0.07, 0.05), 0.0150, 0.14);
        finer(sphereDistance(p, joints.elbow, 0.05), 0.024, 0.1);
        finer(sphereDistance(p, joints.knee, 0.07), 0.028, 0.1);
        finer(sphereDistance(p, joints.shoulder, 0.08), 0.027, 0.1);
        return scale * length;
    };
}

} // namespace quadrille
