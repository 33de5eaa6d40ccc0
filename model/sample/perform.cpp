// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/perform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

double bump(double x, double middle, double width)
{
    const double t = (x - middle) / width;
    return std::exp(-t * t);
}

/// Something soft that hangs on a joint and follows it late: a damped spring.
std::vector<Vec3d> lag(const std::vector<Vec3d>& anchors, double hertz, double damping, double most)
{
    constexpr int substeps = 8;
    const double dt = 1.0 / (sampleFps * substeps);
    const double stiffness = std::pow(2 * std::numbers::pi * hertz, 2);
    const double friction = 2 * damping * std::sqrt(stiffness);
    std::vector<Vec3d> offsets(anchors.size(), Vec3d::Zero());
    Vec3d place = anchors.front();
    Vec3d speed = anchors.size() > 1 ? Vec3d((anchors[1] - anchors[0]) * sampleFps) : Vec3d(Vec3d::Zero());
    for (std::size_t f = 1; f < anchors.size(); ++f) {
        const Vec3d anchorSpeed = (anchors[f] - anchors[f - 1]) * sampleFps;
        for (int i = 1; i <= substeps; ++i) {
            const Vec3d anchor = anchors[f - 1] + (anchors[f] - anchors[f - 1]) * i / substeps;
            // Friction works against the anchor, so that steady motion leaves nothing behind.
            speed += dt * (stiffness * (anchor - place) + friction * (anchorSpeed - speed));
            place += dt * speed;
        }
        const Vec3d offset = place - anchors[f];
        const double size = offset.norm();
        offsets[f] = size > 1e-9 ? Vec3d(offset * (most * std::tanh(size / most) / size)) : offset;
    }
    return offsets;
}

double bendOf(const SkeletonPose& pose, std::size_t joint)
{
    return 2 * std::acos(std::min(1.0, std::abs(pose.rotations[joint].w())));
}

/// How much each soft part of a vertex follows; computed once for the rest pose.
struct Softness
{
    double breath = 0;
    double belly = 0;
    double hem = 0; ///< loose cloth of shirt, sleeves and trouser legs
    double hair = 0;
    std::array<double, 2> biceps{};
    std::array<double, 2> calf{};
    std::array<double, 2> seat{};
};

Softness softness(const Vec3d& p, const Vec3d& n, const Skeleton& skeleton)
{
    Softness s;
    const auto at = [&](const std::string& name) { return skeleton.rest[skeleton.index(name)]; };
    const double trunk = bump(p.x(), 0, 0.17);
    s.breath = trunk * (bump(p.y(), 1.31, 0.10) * (0.35 + 0.65 * std::max(n.z(), 0.0)) +
                        0.5 * bump(p.y(), 1.10, 0.09) * std::max(n.z(), 0.0));
    s.belly = trunk * bump(p.y(), 1.09, 0.085) * std::max(n.z() + 0.2, 0.0);
    for (std::size_t side = 0; side < 2; ++side) {
        const std::string name = side == 0 ? "left" : "right";
        const Vec3d upper = at(name + "Forearm") - at(name + "UpperArm");
        const Vec3d fromShoulder = p - at(name + "UpperArm");
        const double along = fromShoulder.dot(upper) / upper.squaredNorm();
        const double off = (fromShoulder - along * upper).norm();
        const bool isArm = off < 0.09 && (p.x() > 0) == (side == 0);
        if (isArm) {
            s.biceps[side] = bump(along, 0.60, 0.22) * std::max(n.z(), 0.0);
            s.hem = std::max(s.hem, bump(along, 0.62, 0.10));
        }
        const bool isLeg = p.y() < 0.85 && (p.x() > 0) == (side == 0);
        if (isLeg) {
            s.calf[side] = bump(p.y(), 0.36, 0.09) * std::max(-n.z(), 0.0);
            s.hem = std::max(s.hem, 0.8 * bump(p.y(), 0.10, 0.05) * (p.y() > 0.07));
        }
        if ((p.x() > 0) == (side == 0))
            s.seat[side] =
                bump(p.y(), 0.89, 0.07) * std::max(-n.z(), 0.0) * bump(std::abs(p.x()), 0.08, 0.07);
    }
    s.hair = bump(p.y(), 1.745, 0.035) * std::max(0.0, n.y()) * (p.z() > -0.05);
    return s;
}

} // namespace

std::vector<Vec3f> moveSurface(const Performer& performer, const std::vector<SkeletonPose>& poses,
                               double breathPhase)
{
    const Skeleton& skeleton = performer.skeleton;
    const std::size_t vertices = performer.mesh.points.size();
    std::vector<WorldJoints> joints;
    joints.reserve(poses.size());
    for (const SkeletonPose& pose : poses)
        joints.push_back(worldJoints(skeleton, pose));
    const auto track = [&](const std::string& joint, const Vec3d& offset) {
        std::vector<Vec3d> places;
        for (const WorldJoints& world : joints) {
            const std::size_t j = skeleton.index(joint);
            places.push_back(world.positions[j] + world.rotations[j] * offset);
        }
        return places;
    };
    const auto belly = lag(track("spine", {0, 0, 0.1}), 4.0, 0.35, 0.012);
    const auto hair = lag(track("head", {0, 0.2, 0.05}), 4.5, 0.30, 0.010);
    const std::array<std::vector<Vec3d>, 2> seats = {
        lag(track("leftThigh", {0, -0.03, -0.08}), 4.5, 0.4, 0.010),
        lag(track("rightThigh", {0, -0.03, -0.08}), 4.5, 0.4, 0.010)};
    std::vector<Softness> soft(vertices);
    tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t v) {
        soft[v] = softness(performer.mesh.points[v], performer.normals[v], skeleton);
    });
    const std::array<std::size_t, 2> forearms = {skeleton.index("leftForearm"),
                                                 skeleton.index("rightForearm")};
    const std::array<std::size_t, 2> shins = {skeleton.index("leftShin"), skeleton.index("rightShin")};
    const std::array<std::vector<Vec3d>, 4> cloth = {
        lag(track("leftUpperArm", {0.11, -0.13, 0}), 3.2, 0.30, 0.010),
        lag(track("rightUpperArm", {-0.11, -0.13, 0}), 3.2, 0.30, 0.010),
        lag(track("leftShin", {0, -0.36, 0}), 3.6, 0.35, 0.008),
        lag(track("rightShin", {0, -0.36, 0}), 3.6, 0.35, 0.008)};
    std::vector<Vec3f> frames(poses.size() * vertices);
    tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t f) {
        std::vector<Vec3d> bulged = performer.mesh.points;
        const double breath =
            std::sin(breathPhase + 2 * std::numbers::pi * 0.28 * static_cast<double>(f) / sampleFps);
        std::array<double, 2> arms{};
        std::array<double, 2> legs{};
        for (std::size_t side = 0; side < 2; ++side) {
            arms[side] = std::min(bendOf(poses[f], forearms[side]), 2.0);
            legs[side] = std::min(bendOf(poses[f], shins[side]), 1.6);
        }
        for (std::size_t v = 0; v < vertices; ++v) {
            const Softness& s = soft[v];
            double out = 0.0045 * breath * s.breath;
            for (std::size_t side = 0; side < 2; ++side)
                out += 0.009 * s.biceps[side] * arms[side] + 0.006 * s.calf[side] * legs[side];
            bulged[v] += out * performer.normals[v];
        }
        std::vector<Vec3d> moved;
        skin(bulged, performer.weights, skeleton, joints[f], moved);
        for (std::size_t v = 0; v < vertices; ++v) {
            const Softness& s = soft[v];
            const Vec3d& p = performer.mesh.points[v];
            const std::size_t side = p.x() > 0 ? 0 : 1;
            const std::size_t piece = side + (p.y() < 0.5 ? 2 : 0);
            const Vec3d late = s.belly * belly[f] + s.hair * hair[f] + s.seat[side] * seats[side][f] +
                               s.hem * cloth[piece][f];
            frames[f * vertices + v] = (moved[v] + late).cast<float>();
        }
    });
    return frames;
}

} // namespace quadrille
