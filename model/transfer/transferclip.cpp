// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/transferclip.h"

#include "model/core/bounds.h"
#include "model/core/error.h"
#include "model/geometry/surfacevolume.h"
#include "model/geometry/trianglelogs.h"
#include "model/transfer/placement.h"
#include "model/transfer/posecorrection.h"
#include "model/transfer/transfersolver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

Vec3d middleOf(const Triangle& triangle, Positions pose)
{
    return (pose[triangle[0].value] + pose[triangle[1].value] + pose[triangle[2].value]).cast<double>() / 3;
}

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

std::vector<Vec3f> turned(Positions pose, double angle, UpAxis up)
{
    const Eigen::Matrix3d matrix = aboutUp(angle, up).toRotationMatrix();
    std::vector<Vec3f> result;
    result.reserve(pose.size());
    for (const Vec3f& p : pose)
        result.emplace_back((matrix * p.cast<double>()).cast<float>());
    return result;
}

/// The ratio of two bodies' heights; of their diagonals where one of them lies flat.
double sizeRatio(Positions target, Positions reference, UpAxis up)
{
    constexpr double flat = 0.05;
    const Vec3d large = boundsOf(target).size();
    const Vec3d small = boundsOf(reference).size();
    const auto axis = static_cast<Eigen::Index>(up);
    const bool bothStand = large[axis] > flat * large.norm() && small[axis] > flat * small.norm();
    const double ratio = bothStand ? large[axis] / small[axis] : large.norm() / small.norm();
    return std::isfinite(ratio) && ratio > 0 ? ratio : 1;
}

/// What a template does in each frame.
struct TemplateMotion
{
    std::vector<MarkRotations> rotations;
    TemplateCourse course;
};

TemplateMotion follow(const MeshSequence& clip, Positions reference, std::span<const TrianglePair> pairs,
                      UpAxis up, const Progress& progress)
{
    std::vector<Triangle> triangles;
    for (const TrianglePair& pair : pairs)
        triangles.push_back(clip.topology->triangles()[pair.onTemplate.value]);
    MarkTracker tracker(triangles, reference);
    TemplateMotion motion;
    motion.course.fps = clip.fps;
    const std::int64_t count = clip.frameCount();
    motion.course.stands = standingFrames(clip.contacts, count);
    for (FrameIndex f(0); f.value < count; ++f) {
        const Frame frame = clip.frame(f);
        const Positions pose = frame.positions();
        motion.rotations.push_back(tracker.next(pose));
        Vec3d middle = Vec3d::Zero();
        for (const Triangle& triangle : triangles)
            middle += middleOf(triangle, pose) / static_cast<double>(triangles.size());
        motion.course.middles.push_back(middle);
        motion.course.lowest.push_back(boundsOf(pose).min[static_cast<Eigen::Index>(up)]);
        progress.report(f.value + 1, count);
    }
    return motion;
}

/// What marks turn by after each has turned once beforehand.
void afterwards(std::vector<MarkRotations>& rotations, std::span<const Eigen::Quaterniond> beforehand)
{
    for (MarkRotations& frame : rotations) {
        for (std::size_t m = 0; m < beforehand.size(); ++m)
            frame.marks[m] = frame.marks[m] * beforehand[m];
    }
}

/// Measures poses of a target that were made.
class TransferMeter
{
public:
    TransferMeter(const PosedMesh& target, Positions rest, std::span<const TrianglePair> pairs)
        : m_volume(*target.topology)
    {
        for (const TrianglePair& pair : pairs)
            m_triangles.push_back(target.topology->triangles()[pair.onTarget.value]);
        m_rest = poseFrames(m_triangles, rest);
        m_volumeAtRest = m_volume.of(rest).value_or(0);
    }

    bool knowsVolume() const { return m_volumeAtRest != 0; }
    double volume(Positions pose) const { return *m_volume.of(pose) / m_volumeAtRest; }

    double markError(Positions pose, std::span<const Eigen::Quaterniond> wanted) const
    {
        const TriangleLogs logs =
            triangleLogs(m_rest, poseFrames(m_triangles, pose), Eigen::Quaterniond::Identity());
        double sum = 0;
        for (std::size_t m = 0; m < wanted.size(); ++m) {
            const double sine = std::sin(logs.halfAngle[m]);
            const Eigen::Quaterniond got(logs.cosine[m], sine * logs.axisX[m], sine * logs.axisY[m],
                                         sine * logs.axisZ[m]);
            sum += got.angularDistance(wanted[m]);
        }
        return sum / static_cast<double>(wanted.size());
    }

private:
    SurfaceVolume m_volume;
    double m_volumeAtRest = 0;
    std::vector<Triangle> m_triangles;
    PoseFrames m_rest;
};

} // namespace

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

Transferred transferClip(const MeshSequence& clip, const PosedMesh& reference, const PosedMesh& target,
                         std::span<const TrianglePair> pairs, const TransferSettings& settings,
                         const Progress& progress)
{
    checkPairs(*clip.topology, *target.topology, pairs);
    Transferred result;
    result.turn = turnOntoTemplate(reference, target, pairs, settings.up);
    const std::vector<Vec3f> rest = turned(target.positions, result.turn, settings.up);
    const auto solid = std::make_shared<const TransferTarget>(*target.topology, rest);
    std::vector<TriangleIndex> marks;
    marks.reserve(pairs.size());
    for (const TrianglePair& pair : pairs)
        marks.push_back(pair.onTarget);
    const TransferSolver solver(solid, marks, settings.field);
    progress.report(0.05);
    TemplateMotion motion = follow(clip, reference.positions, pairs, settings.up, progress.part(0.05, 0.2));
    if (settings.correctsPose)
        afterwards(motion.rotations, poseCorrections(reference, {target.topology, rest}, pairs));

    const std::size_t vertices = rest.size();
    const std::size_t count = motion.rotations.size();
    result.positions.resize(count * vertices);
    const PosedTarget posed{result.positions, vertices};
    const TransferMeter meter(target, rest, pairs);
    result.markErrors.resize(count);
    if (meter.knowsVolume())
        result.volume.resize(count);
    tbb::enumerable_thread_specific<TransferSolver::Scratch> scratch;
    std::atomic<std::int64_t> done = 0;
    const Progress solving = progress.part(0.2, 0.9);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t f) {
        solver.pose(motion.rotations[f], posed.at(f), scratch.local());
        result.markErrors[f] = meter.markError(posed.at(f), motion.rotations[f].marks);
        if (meter.knowsVolume())
            result.volume[f] = meter.volume(posed.at(f));
        solving.report(++done, static_cast<std::int64_t>(count));
    });
    const double usual = sizeRatio(rest, reference.positions, settings.up);
    result.scale = settings.scale ? *settings.scale : scaleOfSteps(motion.course, posed, settings.up, usual);
    placeOnGround(motion.course, result.scale, settings.up, posed);
    progress.report(1);
    return result;
}

} // namespace quadrille
