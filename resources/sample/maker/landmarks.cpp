// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/nearestpoint.h"
#include "resources/sample/maker/character.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace quadrille {

namespace {

struct Landmark
{
    const char* name;
    FigurePart part;
    Vec3d place; ///< near the surface of the reference figure
    bool isPaired = false;
};

std::vector<Landmark> referenceLandmarks()
{
    const BodyJoints j = referenceJoints();
    const Vec3d along = bodyArmAlong;
    const Vec3d out = bodyArmOut;
    return {{"nose", FigurePart::Head, {0, 1.588, 0.125}},
            {"chin", FigurePart::Head, {0, 1.512, 0.095}},
            {"brow", FigurePart::Head, {0, 1.648, 0.105}},
            {"mouth", FigurePart::Head, {0, 1.551, 0.10}},
            {"crown", FigurePart::Head, {0, 1.76, -0.01}},
            {"nape", FigurePart::Head, {0, 1.56, -0.09}},
            {"Eye", FigurePart::Head, {0.033, 1.619, 0.09}, true},
            {"Ear", FigurePart::Head, {0.096, 1.602, -0.006}, true},
            {"throat", FigurePart::Torso, {0, 1.43, 0.06}},
            {"breastbone", FigurePart::Torso, {0, 1.30, 0.13}},
            {"navel", FigurePart::Torso, {0, 1.09, 0.12}},
            {"upper back", FigurePart::Torso, {0, 1.33, -0.13}},
            {"lower back", FigurePart::Torso, {0, 1.08, -0.11}},
            {"Chest", FigurePart::Torso, {0.08, 1.315, 0.13}, true},
            {"Waist", FigurePart::Torso, {0.16, 1.12, 0}, true},
            {"ShoulderBlade", FigurePart::Torso, {0.08, 1.33, -0.13}, true},
            {"UpperArm", FigurePart::Arm, j.shoulder + 0.10 * along + 0.06 * out, true},
            {"ElbowFront", FigurePart::Arm, j.elbow + Vec3d(0, 0, 0.05), true},
            {"ElbowBack", FigurePart::Arm, j.elbow - Vec3d(0, 0, 0.05), true},
            {"Wrist", FigurePart::Hand, j.wrist + 0.03 * out, true},
            {"BackOfHand", FigurePart::Hand, j.wrist + 0.05 * along + 0.02 * out, true},
            {"Palm", FigurePart::Hand, j.wrist + 0.05 * along - 0.02 * out, true},
            {"MiddleFinger", FigurePart::Hand, j.wrist + 0.18 * along + Vec3d(0, 0, 0.013), true},
            {"Thumb", FigurePart::Hand, j.wrist + 0.095 * along + Vec3d(0, 0, 0.062) - 0.024 * out, true},
            {"Hip", FigurePart::Leg, {0.172, 0.92, 0}, true},
            {"Seat", FigurePart::Leg, {0.08, 0.89, -0.14}, true},
            {"Thigh", FigurePart::Leg, {0.097, 0.70, 0.09}, true},
            {"Knee", FigurePart::Leg, {0.099, 0.51, 0.08}, true},
            {"KneeBack", FigurePart::Leg, {0.099, 0.51, -0.06}, true},
            {"Calf", FigurePart::Leg, {0.102, 0.35, -0.085}, true},
            {"Heel", FigurePart::Foot, {0.095, 0.03, -0.10}, true},
            {"ToeTip", FigurePart::Foot, j.toeTip + Vec3d(0, 0, 0.01), true},
            {"Instep", FigurePart::Foot, j.ankle + Vec3d(0.008, -0.01, 0.07), true}};
}

SurfacePoint nearestOnSurface(const SurfaceMesh& mesh, const Vec3d& p)
{
    SurfacePoint best;
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3d& a = mesh.points[mesh.triangles[t][0].value];
        const Vec3d& b = mesh.points[mesh.triangles[t][1].value];
        const Vec3d& c = mesh.points[mesh.triangles[t][2].value];
        const Vec3d w = nearestWeights({a, b, c}, p);
        const double d = (w.x() * a + w.y() * b + w.z() * c - p).squaredNorm();
        if (d < nearest) {
            nearest = d;
            best = {TriangleIndex(t), w};
        }
    }
    return best;
}

} // namespace

std::vector<LandmarkPair> makeLandmarks(const Body& one, const SurfaceMesh& oneMesh, const Body& other,
                                        const SurfaceMesh& otherMesh)
{
    std::vector<LandmarkPair> pairs;
    const auto add = [&](const std::string& name, FigurePart part, const Vec3d& place) {
        pairs.push_back({name, nearestOnSurface(oneMesh, one.fromReference(place, part)),
                         nearestOnSurface(otherMesh, other.fromReference(place, part))});
    };
    for (const Landmark& mark : referenceLandmarks()) {
        if (!mark.isPaired) {
            add(mark.name, mark.part, mark.place);
            continue;
        }
        add(std::string("left") + mark.name, mark.part, mark.place);
        add(std::string("right") + mark.name, mark.part, mark.place.cwiseProduct(Vec3d(-1, 1, 1)));
    }
    return pairs;
}

} // namespace quadrille
