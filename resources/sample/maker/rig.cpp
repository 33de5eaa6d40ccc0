// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/rig.h"

namespace quadrille {

Skeleton makeSkeleton(const Body& body)
{
    const BodyJoints& j = body.joints();
    Skeleton s;
    const auto add = [&](const std::string& name, const std::string& parent, const Vec3d& place) {
        s.parents.push_back(parent.empty() ? -1 : static_cast<int>(s.index(parent)));
        s.names.push_back(name);
        s.rest.push_back(place);
    };
    add("hips", "", j.hips);
    add("spine", "hips", j.spine);
    add("chest", "spine", j.chest);
    add("neck", "chest", j.neck);
    add("head", "neck", j.head);
    for (const char* side : {"left", "right"}) {
        const std::string name(side);
        const double sign = name == "left" ? 1 : -1;
        const auto at = [sign](const Vec3d& p) { return Vec3d(sign * p.x(), p.y(), p.z()); };
        add(name + "Clavicle", "chest", at(j.clavicle));
        add(name + "UpperArm", name + "Clavicle", at(j.shoulder));
        add(name + "Forearm", name + "UpperArm", at(j.elbow));
        add(name + "Hand", name + "Forearm", at(j.wrist));
        add(name + "Fingers", name + "Hand", at(j.knuckles));
    }
    for (const char* side : {"left", "right"}) {
        const std::string name(side);
        const double sign = name == "left" ? 1 : -1;
        const auto at = [sign](const Vec3d& p) { return Vec3d(sign * p.x(), p.y(), p.z()); };
        add(name + "Thigh", "hips", at(j.hip));
        add(name + "Shin", name + "Thigh", at(j.knee));
        add(name + "Foot", name + "Shin", at(j.ankle));
        add(name + "Toes", name + "Foot", at(j.ball));
    }
    return s;
}

} // namespace quadrille
