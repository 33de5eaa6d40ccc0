// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/rig.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numeric>

namespace quadrille {

namespace {

struct Bone
{
    std::size_t joint;
    Vec3d from;
    Vec3d to;
};

double distanceToBone(const Vec3d& p, const Bone& bone)
{
    const Vec3d axis = bone.to - bone.from;
    const double t = std::clamp((p - bone.from).dot(axis) / std::max(axis.squaredNorm(), 1e-12), 0.0, 1.0);
    return (p - bone.from - t * axis).norm();
}

/// The bones of all joints; trunk bones are as wide as the trunk, so that its sides do not follow the limbs.
std::vector<Bone> bonesOf(const Skeleton& s)
{
    std::vector<Bone> bones;
    const auto at = [&](const std::string& name) { return s.rest[s.index(name)]; };
    const auto add = [&](const std::string& joint, const Vec3d& from, const Vec3d& to) {
        bones.push_back({s.index(joint), from, to});
    };
    const double hipWidth = at("leftThigh").x();
    const double shoulderWidth = at("leftUpperArm").x();
    const auto across = [&](const std::string& joint, double y, double width) {
        add(joint, {-width, y, 0}, {width, y, 0});
    };
    across("hips", at("hips").y() + 0.02, hipWidth * 1.25);
    across("hips", at("hips").y() - 0.03, hipWidth * 0.8);
    across("spine", 0.5 * (at("spine").y() + at("chest").y()) - 0.03, hipWidth * 0.9);
    across("chest", at("chest").y() + 0.04, shoulderWidth * 0.62);
    across("chest", at("chest").y() + 0.10, shoulderWidth * 0.60);
    add("chest", at("chest"), at("neck") - Vec3d(0, 0.03, 0));
    add("neck", at("neck"), at("head"));
    add("head", at("head") + Vec3d(0, 0.02, 0.02), at("head") + Vec3d(0, 0.16, 0));
    for (const std::string side : {"left", "right"}) {
        const Vec3d shoulder = at(side + "UpperArm");
        const Vec3d clavicle = at(side + "Clavicle");
        add(side + "Clavicle", clavicle + 0.35 * (shoulder - clavicle),
            clavicle + 0.85 * (shoulder - clavicle));
        add(side + "UpperArm", shoulder, at(side + "Forearm"));
        add(side + "Forearm", at(side + "Forearm"), at(side + "Hand"));
        add(side + "Hand", at(side + "Hand"), at(side + "Fingers"));
        const Vec3d hand = at(side + "Fingers") - at(side + "Hand");
        add(side + "Hand", at(side + "Hand") + 0.2 * hand + Vec3d(0, 0, 0.024),
            at(side + "Hand") + 0.9 * hand + Vec3d(0, 0, 0.062));
        add(side + "Fingers", at(side + "Fingers") + 0.1 * hand, at(side + "Fingers") + hand);
        const Vec3d thigh = at(side + "Thigh");
        add(side + "Thigh", thigh + 0.10 * (at(side + "Shin") - thigh), at(side + "Shin"));
        add(side + "Shin", at(side + "Shin"), at(side + "Foot"));
        add(side + "Foot", at(side + "Foot") - Vec3d(0, 0.05, 0.04), at(side + "Toes"));
        add(side + "Toes", at(side + "Toes"),
            at(side + "Toes") + 0.6 * (at(side + "Toes") - at(side + "Foot")).cwiseProduct(Vec3d(1, 0, 1)));
    }
    return bones;
}

using Sparse = Eigen::SparseMatrix<double>;

/// Cotangent Laplacian over vertex areas (positive semi-definite, not symmetric) times the areas.
Sparse cotangentMatrix(const SurfaceMesh& mesh, Eigen::VectorXd& areas)
{
    std::vector<Eigen::Triplet<double>> entries;
    areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size()));
    for (const Triangle& t : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto i = static_cast<int>(t[(c + 1) % 3].value);
            const auto j = static_cast<int>(t[(c + 2) % 3].value);
            const Vec3d a = mesh.points[t[(c + 1) % 3].value] - mesh.points[t[c].value];
            const Vec3d b = mesh.points[t[(c + 2) % 3].value] - mesh.points[t[c].value];
            const double twiceArea = a.cross(b).norm();
            const double w = std::max(0.5 * a.dot(b) / twiceArea, 0.02);
            entries.emplace_back(i, i, w);
            entries.emplace_back(j, j, w);
            entries.emplace_back(i, j, -w);
            entries.emplace_back(j, i, -w);
            areas[static_cast<Eigen::Index>(t[c].value)] += twiceArea / 6;
        }
    const auto n = static_cast<Eigen::Index>(mesh.points.size());
    Sparse L(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    return L;
}

} // namespace

std::vector<VertexWeights> boneHeatWeights(const SurfaceMesh& mesh, const Skeleton& skeleton)
{
    const std::vector<Bone> bones = bonesOf(skeleton);
    Eigen::VectorXd areas;
    Sparse A = cotangentMatrix(mesh, areas);
    const auto n = static_cast<Eigen::Index>(mesh.points.size());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(skeleton.size()));
    for (Eigen::Index v = 0; v < n; ++v) {
        const Vec3d& p = mesh.points[static_cast<std::size_t>(v)];
        double nearest = 1e9;
        std::size_t joint = 0;
        for (const Bone& bone : bones)
            if (const double d = distanceToBone(p, bone); d < nearest) {
                nearest = d;
                joint = bone.joint;
            }
        constexpr double heatFactor = 0.7;
        const double heat = heatFactor * areas[v] / (nearest * nearest);
        A.coeffRef(v, v) += heat;
        right(v, static_cast<Eigen::Index>(joint)) = heat;
    }
    const Eigen::SimplicialLDLT<Sparse> solver(A);
    const Eigen::MatrixXd solution = solver.solve(right);
    std::vector<VertexWeights> weights(mesh.points.size());
    std::vector<std::size_t> order(skeleton.size());
    for (Eigen::Index v = 0; v < n; ++v) {
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return solution(v, static_cast<Eigen::Index>(a)) > solution(v, static_cast<Eigen::Index>(b));
        });
        VertexWeights& w = weights[static_cast<std::size_t>(v)];
        double sum = 0;
        for (std::size_t k = 0; k < 4; ++k)
            sum += std::max(solution(v, static_cast<Eigen::Index>(order[k])), 0.0);
        for (std::size_t k = 0; k < 4; ++k) {
            w.joints[k] = static_cast<std::uint16_t>(order[k]);
            w.weights[k] =
                static_cast<float>(std::max(solution(v, static_cast<Eigen::Index>(order[k])), 0.0) / sum);
        }
    }
    return weights;
}

} // namespace quadrille
