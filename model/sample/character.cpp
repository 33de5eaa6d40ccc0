// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/character.h"

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

EdgeLength edgeLengthFor(const Body& body, double scale)
{
    const BodyJoints joints = body.joints();
    return [&body, joints, scale](const Vec3d& point) {
        const Vec3d p(std::abs(point.x()), point.y(), point.z());
        double length = 0.036;
        // \param growth of the length per metre away from the feature.
        const auto finer = [&](double distance, double near, double growth) {
            length = std::min(length, near + growth * std::max(distance, 0.0));
        };
        const Vec3d head = body.toReference(p, BodyPart::Head);
        finer(ellipsoidDistance(head, {0, 1.59, 0.085}, {0.05, 0.062, 0.045}), 0.0098, 0.20);
        finer(ellipsoidDistance(head, {0, 1.64, 0}, {0.09, 0.11, 0.11}), 0.0170, 0.20);
        finer(sphereDistance(head, {0.084, 1.602, -0.006}, 0.03), 0.0120, 0.20);
        finer(taperedCapsuleDistance(p, joints.wrist, joints.fingertips, 0.03, 0.07), 0.0100, 0.16);
        finer(taperedCapsuleDistance(p, joints.ankle, joints.toeTip, 0.07, 0.05), 0.0185, 0.12);
        finer(sphereDistance(p, joints.elbow, 0.05), 0.024, 0.1);
        finer(sphereDistance(p, joints.knee, 0.07), 0.028, 0.1);
        finer(sphereDistance(p, joints.shoulder, 0.08), 0.027, 0.1);
        return scale * length;
    };
}

} // namespace quadrille
