// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/preparedtransfer.h"

#include "model/core/bounds.h"
#include "model/geometry/trianglelogs.h"
#include "model/transfer/posecorrection.h"
#include "model/transfer/stretchtracker.h"

#include <Eigen/Geometry>
#include <cmath>

namespace quadrille {

namespace {

std::vector<TriangleIndex> marksOf(std::span<const TrianglePair> pairs)
{
    std::vector<TriangleIndex> marks;
    marks.reserve(pairs.size());
    for (const TrianglePair& pair : pairs)
        marks.push_back(pair.onTarget);
    return marks;
}

/// The ratio of two bodies' heights; of their diagonals where one of them lies flat.
double ratioOfSizes(Positions target, Positions reference, UpAxis up)
{
    constexpr double flat = 0.05;
    const Vec3d large = boundsOf(target).size();
    const Vec3d small = boundsOf(reference).size();
    const auto axis = static_cast<Eigen::Index>(up);
    const bool bothStand = large[axis] > flat * large.norm() && small[axis] > flat * small.norm();
    const double ratio = bothStand ? large[axis] / small[axis] : large.norm() / small.norm();
    return std::isfinite(ratio) && ratio > 0 ? ratio : 1;
}

} // namespace

PreparedTransfer::PreparedTransfer(const MeshSequence& clip, const PosedMesh& reference,
                                   const PosedMesh& target, std::shared_ptr<const TransferTarget> solid,
                                   std::span<const TrianglePair> pairs, const TransferSettings& settings,
                                   const Progress& progress)
    : m_vertices(target.positions.size())
    , m_turn(turnOntoTemplate(reference, target, pairs, settings.up))
    , m_sizeRatio(ratioOfSizes(target.positions, reference.positions, settings.up))
    , m_solver(std::move(solid), marksOf(pairs), settings.field, settings.marksSurroundings)
    , m_volume(*target.topology)
    , m_volumeAtRest(m_volume.of(target.positions).value_or(0))
{
    for (const TrianglePair& pair : pairs)
        m_triangles.push_back(target.topology->triangles()[pair.onTarget.value]);
    m_rest = poseFrames(m_triangles, target.positions);
    const PosedSurface surface(reference);
    follow(clip, surface, pairs, settings, progress);
    turnBeforehand(surface, target, pairs, settings);
}

void PreparedTransfer::follow(const MeshSequence& clip, const PosedSurface& reference,
                              std::span<const TrianglePair> pairs, const TransferSettings& settings,
                              const Progress& progress)
{
    std::vector<Triangle> triangles;
    for (const TrianglePair& pair : pairs)
        triangles.push_back(clip.topology->triangles()[pair.onTemplate.value]);
    MarkTracker tracker(settings.marksSurroundings ? patchesAbout(reference, pairs, PatchReach::NextMark)
                                                   : singleTriangles(triangles),
                        reference.mesh().positions);
    std::optional<StretchTracker> stretches;
    if (settings.carriesStretch)
        stretches.emplace(patchesAbout(reference, pairs, PatchReach::Whole), reference.mesh().positions);
    m_course.fps = clip.fps;
    const std::int64_t count = clip.frameCount();
    m_course.stands = standingFrames(clip.contacts, count);
    m_course.slides.assign(static_cast<std::size_t>(count), Vec3d::Zero());
    std::vector<Vec3f> before;
    for (FrameIndex f(0); f.value < count; ++f) {
        const Frame frame = clip.frame(f);
        const Positions pose = frame.positions();
        m_deformations.push_back(tracker.next(pose));
        if (stretches)
            m_deformations.back().stretches = stretches->next(pose);
        Vec3d middle = Vec3d::Zero();
        for (const Triangle& triangle : triangles)
            middle += middleOf(triangle, pose) / static_cast<double>(triangles.size());
        m_course.middles.push_back(middle);
        m_course.lowest.push_back(boundsOf(pose).min[static_cast<Eigen::Index>(settings.up)]);
        if (f.value > 0)
            m_course.slides[static_cast<std::size_t>(f.value - 1)] =
                wayOfSoles(before, pose, settings.up).value_or(Vec3d::Zero());
        before.assign(pose.begin(), pose.end());
        progress.report(f.value + 1, count);
    }
    m_course.ground = groundOf(m_course);
}

/// Marks turn from the target's own pose: first as the body turns onto the template, then into its reference
/// pose.
void PreparedTransfer::turnBeforehand(const PosedSurface& reference, const PosedMesh& target,
                                      std::span<const TrianglePair> pairs, const TransferSettings& settings)
{
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(m_turn, Vec3d::Unit(static_cast<Eigen::Index>(settings.up))));
    std::vector<Eigen::Quaterniond> before(pairs.size(), turn);
    if (settings.correctsPose) {
        const std::vector<Eigen::Quaterniond> corrections = poseCorrections(
            reference, {target.topology, turned(target.positions, m_turn, settings.up)}, pairs);
        for (std::size_t m = 0; m < pairs.size(); ++m)
            before[m] = corrections[m] * turn;
    }
    for (MarkDeformations& frame : m_deformations) {
        for (std::size_t m = 0; m < before.size(); ++m)
            frame.rotations[m] = frame.rotations[m] * before[m];
        // What is stretched is the target in its own pose.
        for (std::size_t m = 0; m < frame.stretches.size(); ++m) {
            const Eigen::Matrix3d onto = before[m].toRotationMatrix();
            frame.stretches[m] = onto.transpose() * frame.stretches[m] * onto;
        }
        frame.root = frame.root * turn;
    }
}

double PreparedTransfer::markError(std::size_t frame, Positions pose) const
{
    const std::vector<Eigen::Quaterniond>& wanted = m_deformations[frame].rotations;
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

} // namespace quadrille
