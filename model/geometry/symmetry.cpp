// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/symmetry.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/geometry/procrustes.h"
#include "model/geometry/shapesymmetry.h"
#include "model/geometry/symmetrygrowth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace quadrille {

namespace {

/// Maps of the connectivity that change lengths more are no symmetry of a body.
constexpr double greatestLengthError = 0.3;

[[noreturn]] void refuseMap(const std::filesystem::path& file, const std::string& reason)
{
    throw Error(ErrorCode::SymmetryMapWrong, {file, {}, {{"reason", reason}}});
}

/// Axes of a triangle's own frame, as columns; the identity where it has no area.
Eigen::Matrix3d axesOf(const Triangle& triangle, Positions pose)
{
    const Vec3d last = pose[triangle[2].value].cast<double>();
    const Vec3d first = pose[triangle[0].value].cast<double>() - last;
    const Vec3d normal = first.cross(pose[triangle[1].value].cast<double>() - last);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (normal.squaredNorm() > 0) {
        axes.col(0) = first.normalized();
        axes.col(2) = normal.normalized();
        axes.col(1) = axes.col(2).cross(axes.col(0));
    }
    return axes;
}

Vec3d weightedCorner(const OppositePoint& point, Positions pose)
{
    Vec3d sum = Vec3d::Zero();
    for (std::size_t c = 0; c < 3; ++c)
        sum += static_cast<double>(point.weights[static_cast<Eigen::Index>(c)]) *
               pose[point.corners[c].value].cast<double>();
    return sum;
}

/// The offsets that make the pose its own reflection.
Symmetry symmetryOfShape(const Topology& topology, Positions pose, const ShapeSymmetry& shape,
                         double tolerance)
{
    Symmetry symmetry;
    std::size_t near = 0;
    for (std::uint32_t v = 0; v < pose.size(); ++v) {
        const ShapeSymmetry::Counterpart& found = shape.counterparts[v];
        OppositePoint point{.corners = topology.triangles()[found.triangle.value], .weights = found.weights};
        const Vec3d off = shape.plane.reflected(pose[v].cast<double>()) - weightedCorner(point, pose);
        near += off.norm() <= tolerance ? 1 : 0;
        point.offset = (axesOf(point.corners, pose).transpose() * off).cast<float>();
        symmetry.points.push_back(point);
    }
    symmetry.share = static_cast<double>(near) / static_cast<double>(std::max<std::size_t>(pose.size(), 1));
    return symmetry;
}

} // namespace

Symmetry findSymmetry(const Topology& topology, Positions pose, const SymmetrySettings& settings,
                      const Progress& progress)
{
    progress.report(0.0);
    if (pose.size() != topology.vertexCount())
        throw Error(ErrorCode::VertexCountMismatch, {{},
                                                     {},
                                                     {{"expected", std::to_string(topology.vertexCount())},
                                                      {"found", std::to_string(pose.size())}}});
    std::optional<ShapeSymmetry> shape;
    if (hasTwins(topology))
        shape = shapeSymmetry(topology, pose, progress.part(0, 0.4));
    std::optional<GrownSymmetry> best;
    for (const bool joinsFans : {false, true}) {
        const std::optional<ReflectionPlane> plane = shape ? std::optional(shape->plane) : std::nullopt;
        auto found = grownSymmetry(topology, faceEdges(topology, joinsFans), pose, plane,
                                   progress.part(joinsFans ? 0.5 : 0.4, joinsFans ? 0.6 : 0.5));
        if (found && found->lengthError <= greatestLengthError &&
            (!best || found->lengthError < best->lengthError))
            best = std::move(found);
    }
    if (best)
        return {.opposite = std::move(best->opposite), .points = {}, .share = 1};
    if (!shape)
        shape = shapeSymmetry(topology, pose, progress.part(0.6, 1));
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : pose)
        box.extend(p);
    const double diagonal = static_cast<double>(box.diagonal().norm());
    Symmetry symmetry = symmetryOfShape(topology, pose, *shape, settings.tolerance * diagonal);
    if (symmetry.share < settings.leastShare)
        throw Error(ErrorCode::NoSymmetry,
                    {{}, {}, {{"share", std::to_string(std::lround(100 * symmetry.share))}}});
    progress.report(1.0);
    return symmetry;
}

Symmetry checkedSymmetry(const Topology& topology, std::vector<VertexIndex> opposite,
                         const std::filesystem::path& file)
{
    const std::uint32_t count = topology.vertexCount();
    if (opposite.size() != count)
        refuseMap(file, "it has " + std::to_string(opposite.size()) + " entries for " +
                            std::to_string(count) + " vertices");
    bool moves = false;
    for (std::uint32_t v = 0; v < count; ++v) {
        const std::uint32_t other = opposite[v].value;
        if (other >= count)
            refuseMap(file, "vertex " + std::to_string(v) + " is opposite vertex " + std::to_string(other) +
                                ", which does not exist");
        if (opposite[other].value != v)
            refuseMap(file, "vertex " + std::to_string(v) + " is opposite vertex " + std::to_string(other) +
                                ", but that one is opposite vertex " + std::to_string(opposite[other].value));
        moves = moves || other != v;
    }
    if (!moves)
        refuseMap(file, "every vertex is its own counterpart");
    if (!reversesFaces(faceEdges(topology, false), opposite) &&
        !reversesFaces(faceEdges(topology, true), opposite))
        refuseMap(file, "faces are not opposite faces");
    return {.opposite = std::move(opposite), .points = {}, .share = 1};
}

std::vector<Vec3f> counterparts(const Symmetry& symmetry, Positions pose)
{
    std::vector<Vec3f> places;
    places.reserve(pose.size());
    for (const VertexIndex other : symmetry.opposite)
        places.push_back(pose[other.value]);
    for (const OppositePoint& point : symmetry.points) {
        const Vec3d offset = axesOf(point.corners, pose) * point.offset.cast<double>();
        places.push_back((weightedCorner(point, pose) + offset).cast<float>());
    }
    return places;
}

ReflectionPlane reflectionPlane(Positions points, Positions counterparts)
{
    const Vec3d centre = centroid(points);
    const Vec3d other = centroid(counterparts);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
        sum.noalias() +=
            (points[i].cast<double>() - centre) * (counterparts[i].cast<double>() - other).transpose();
    // Reflection I − 2·n·nᵀ fits best where nᵀ·C·n is least.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver((sum + sum.transpose()) / 2);
    return {.normal = solver.eigenvectors().col(0), .point = (centre + other) / 2};
}

} // namespace quadrille
