// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/skeleton.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

std::size_t Skeleton::index(const std::string& name) const
{
    const auto it = std::find(names.begin(), names.end(), name);
    assert(it != names.end());
    return static_cast<std::size_t>(it - names.begin());
}

WorldJoints worldJoints(const Skeleton& skeleton, const SkeletonPose& pose)
{
    WorldJoints world;
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
        if (skeleton.parents[j] < 0) {
            world.positions.push_back(pose.root);
            world.rotations.push_back(pose.rotations[j]);
            continue;
        }
        const auto parent = static_cast<std::size_t>(skeleton.parents[j]);
        world.positions.push_back(world.positions[parent] +
                                  world.rotations[parent] * (skeleton.rest[j] - skeleton.rest[parent]));
        world.rotations.push_back((world.rotations[parent] * pose.rotations[j]).normalized());
    }
    return world;
}

Vec3d centreOfMass(const Skeleton& skeleton, const WorldJoints& joints)
{
    struct Segment
    {
        const char* from;
        const char* to;
        double share;
        double at; ///< of the way
    };
    Vec3d sum = Vec3d::Zero();
    const auto add = [&](const std::string& from, const std::string& to, double share, double at) {
        const Vec3d& a = joints.positions[skeleton.index(from)];
        const Vec3d& b = joints.positions[skeleton.index(to)];
        sum += share * (a + at * (b - a));
    };
    add("hips", "spine", 0.14, 0.0);
    add("spine", "chest", 0.14, 0.5);
    add("chest", "neck", 0.16, 0.4);
    add("neck", "head", 0.07, 1.4);
    for (const char* side : {"left", "right"}) {
        const std::string name(side);
        for (const auto& [from, to, share, at] :
             {Segment{"UpperArm", "Forearm", 0.027, 0.55}, Segment{"Forearm", "Hand", 0.016, 0.45},
              Segment{"Hand", "Fingers", 0.006, 0.8}, Segment{"Thigh", "Shin", 0.142, 0.41},
              Segment{"Shin", "Foot", 0.040, 0.44}, Segment{"Foot", "Toes", 0.014, 0.5}})
            add(name + from, name + to, share, at);
    }
    return sum;
}

void skin(const std::vector<Vec3d>& rest, const std::vector<VertexWeights>& weights, const Skeleton& skeleton,
          const WorldJoints& joints, std::vector<Vec3d>& out)
{
    std::vector<Eigen::Vector4d> real(skeleton.size());
    std::vector<Eigen::Vector4d> dual(skeleton.size());
    for (std::size_t j = 0; j < skeleton.size(); ++j) {
        const Eigen::Quaterniond& q = joints.rotations[j];
        const Vec3d t = joints.positions[j] - q * skeleton.rest[j];
        real[j] = q.coeffs();
        dual[j] = 0.5 * (Eigen::Quaterniond(0, t.x(), t.y(), t.z()) * q).coeffs();
    }
    out.resize(rest.size());
    for (std::size_t v = 0; v < rest.size(); ++v) {
        const VertexWeights& w = weights[v];
        const Eigen::Vector4d& pivot = real[w.joints[0]];
        Eigen::Vector4d r = Eigen::Vector4d::Zero();
        Eigen::Vector4d d = Eigen::Vector4d::Zero();
        for (std::size_t k = 0; k < 4; ++k) {
            const double weight = real[w.joints[k]].dot(pivot) < 0 ? -w.weights[k] : w.weights[k];
            r += weight * real[w.joints[k]];
            d += weight * dual[w.joints[k]];
        }
        const double length = r.norm();
        const Eigen::Quaterniond q(Eigen::Vector4d(r / length));
        const Eigen::Quaterniond e(Eigen::Vector4d(d / length));
        out[v] = q * rest[v] + 2.0 * (e * q.conjugate()).vec();
    }
}

} // namespace quadrille
