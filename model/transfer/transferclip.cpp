// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/transferclip.h"

#include "model/core/error.h"
#include "model/transfer/preparedtransfer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Middles of the marked triangles of both meshes, centred.
struct MarkPlaces
{
    MarkPlaces(const Topology& mesh, Positions pose, const PosedMesh& target,
               std::span<const TrianglePair> pairs, UpAxis up);

    std::vector<Vec3d> source;
    std::vector<Vec3d> target;
    double turn = 0; ///< that brings the target's nearest to the source's, about the up axis
};

MarkPlaces::MarkPlaces(const Topology& mesh, Positions pose, const PosedMesh& posed,
                       std::span<const TrianglePair> pairs, UpAxis up)
{
    for (const TrianglePair& pair : pairs) {
        source.push_back(middleOf(mesh.triangles()[pair.onTemplate.value], pose));
        target.push_back(middleOf(posed.topology->triangles()[pair.onTarget.value], posed.positions));
    }
    for (std::vector<Vec3d>* places : {&source, &target}) {
        Vec3d mean = Vec3d::Zero();
        for (const Vec3d& p : *places)
            mean += p / static_cast<double>(places->size());
        for (Vec3d& p : *places)
            p -= mean;
    }
    const Vec3d axis = Vec3d::Unit(static_cast<Eigen::Index>(up));
    double sine = 0;
    double cosine = 0;
    for (std::size_t m = 0; m < source.size(); ++m) {
        sine += axis.dot(target[m].cross(source[m]));
        cosine += target[m].dot(source[m]) - axis.dot(target[m]) * axis.dot(source[m]);
    }
    turn = sine == 0 && cosine == 0 ? 0 : std::atan2(sine, cosine);
}

Eigen::AngleAxisd aboutUp(double angle, UpAxis up)
{
    return {angle, Vec3d::Unit(static_cast<Eigen::Index>(up))};
}

} // namespace

Vec3d middleOf(const Triangle& triangle, Positions pose)
{
    return (pose[triangle[0].value] + pose[triangle[1].value] + pose[triangle[2].value]).cast<double>() / 3;
}

Vec3d normalOf(const Triangle& triangle, Positions pose)
{
    const auto corner = [&](std::size_t c) -> Vec3d { return pose[triangle[c].value].cast<double>(); };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
}

void checkPairs(const Topology& reference, const Topology& target, std::span<const TrianglePair> pairs)
{
    if (pairs.empty())
        throw Error(ErrorCode::TransferNoPairs);
    std::set<TriangleIndex> seen;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto check = [&](TriangleIndex triangle, const Topology& mesh, ErrorCode code) {
            if (triangle.value < mesh.triangles().size())
                return;
            throw Error(code, {.values = {{"pair", std::to_string(i + 1)},
                                          {"triangle", std::to_string(triangle.value)},
                                          {"count", std::to_string(mesh.triangles().size())}}});
        };
        check(pairs[i].onTemplate, reference, ErrorCode::TransferTriangleOfTemplate);
        check(pairs[i].onTarget, target, ErrorCode::TransferTriangleOfTarget);
        if (!seen.insert(pairs[i].onTarget).second) {
            throw Error(ErrorCode::TransferTriangleTwice,
                        {.values = {{"triangle", std::to_string(pairs[i].onTarget.value)}}});
        }
    }
}

double turnOntoTemplate(const PosedMesh& reference, const PosedMesh& target,
                        std::span<const TrianglePair> pairs, UpAxis up)
{
    return MarkPlaces(*reference.topology, reference.positions, target, pairs, up).turn;
}

double poseDifference(const Topology& mesh, Positions pose, const PosedMesh& target,
                      std::span<const TrianglePair> pairs, UpAxis up)
{
    const MarkPlaces places(mesh, pose, target, pairs, up);
    const Eigen::Matrix3d matrix = aboutUp(places.turn, up).toRotationMatrix();
    double product = 0;
    double square = 0;
    double extent = 0;
    for (std::size_t m = 0; m < pairs.size(); ++m) {
        product += places.source[m].dot(matrix * places.target[m]);
        square += places.source[m].squaredNorm();
        extent += places.target[m].squaredNorm();
    }
    if (extent == 0)
        return 0;
    // What is left of the target's once the template's are scaled best.
    const double explained = square > 0 && product > 0 ? product * product / square : 0;
    return std::sqrt(std::max(0.0, extent - explained) / extent);
}

std::vector<Vec3f> turned(Positions pose, double angle, UpAxis up)
{
    const Eigen::Matrix3d matrix = aboutUp(angle, up).toRotationMatrix();
    std::vector<Vec3f> result;
    result.reserve(pose.size());
    for (const Vec3f& p : pose)
        result.emplace_back((matrix * p.cast<double>()).cast<float>());
    return result;
}

Transferred transferClip(const MeshSequence& clip, const PosedMesh& reference, const PosedMesh& target,
                         std::span<const TrianglePair> pairs, const TransferSettings& settings,
                         const Progress& progress)
{
    checkPairs(*clip.topology, *target.topology, pairs);
    const auto solid = std::make_shared<const TransferTarget>(*target.topology, target.positions);
    progress.report(0.05);
    const PreparedTransfer prepared(clip, reference, target, solid, pairs, settings,
                                    progress.part(0.05, 0.2));
    Transferred result{.turn = prepared.turn()};
    const std::size_t count = prepared.frames();
    result.positions.resize(count * prepared.vertices());
    const PosedTarget posed{result.positions, prepared.vertices()};
    result.markErrors.resize(count);
    if (prepared.knowsVolume())
        result.volume.resize(count);
    tbb::enumerable_thread_specific<TransferSolver::Scratch> scratch;
    std::atomic<std::int64_t> done = 0;
    const Progress solving = progress.part(0.2, 0.9);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t f) {
        prepared.pose(f, posed.at(f), scratch.local());
        result.markErrors[f] = prepared.markError(f, posed.at(f));
        if (prepared.knowsVolume())
            result.volume[f] = prepared.volumeOf(posed.at(f));
        solving.report(++done, static_cast<std::int64_t>(count));
    });
    result.scale = settings.scale ? *settings.scale
                                  : scaleOfSteps(prepared.course(), posed, settings.up, prepared.sizeRatio());
    placeOnGround(prepared.course(), result.scale, settings.up, posed);
    progress.report(1);
    return result;
}

} // namespace quadrille
