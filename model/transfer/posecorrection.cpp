// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/posecorrection.h"

#include "model/transfer/pliablesurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr std::size_t fewestPairs = 4;
/// Rounds between which it is seen anew how well each mark fits, and so often that is.
constexpr int roundsALook = 15;
constexpr int markLooks = 6;
/// The first ones hold all marks alike: limbs have to get there.
constexpr int looksAtNone = 2;
/// A mark that misses its place by so much of the marks' spread counts half.
constexpr double halfMiss = 0.14;
/// Turns up to the first angle are not carried, from the second on all of them, radians.
constexpr double ignored = 7 * std::numbers::pi / 180;
constexpr double carried = 10 * std::numbers::pi / 180;

std::vector<Vec3d> middlesOf(const PosedMesh& mesh, std::span<const TrianglePair> pairs,
                             TriangleIndex TrianglePair::*which)
{
    std::vector<Vec3d> middles;
    middles.reserve(pairs.size());
    for (const TrianglePair& pair : pairs)
        middles.push_back(middleOf(mesh.topology->triangles()[(pair.*which).value], mesh.positions));
    return middles;
}

/// Whether one is more like the other seen in a mirror.
bool areMirrored(std::span<const Vec3d> from, std::span<const Vec3d> onto)
{
    constexpr double flat = 1e-4;
    const Spread spreadFrom = spreadOf(from);
    const Spread spreadOnto = spreadOf(onto);
    const double size = spreadFrom.size * spreadOnto.size * static_cast<double>(from.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t m = 0; m < from.size(); ++m)
        covariance += (onto[m] - spreadOnto.middle) * (from[m] - spreadFrom.middle).transpose() / size;
    return covariance.determinant() < -flat;
}

/// Turns of a few degrees become none, without a step.
Eigen::Quaterniond withoutSmallTurns(const Eigen::Quaterniond& q)
{
    const Eigen::AngleAxisd turn(q);
    const double share = std::clamp((turn.angle() - ignored) / (carried - ignored), 0.0, 1.0);
    return Eigen::Quaterniond(Eigen::AngleAxisd(turn.angle() * share * share * (3 - 2 * share), turn.axis()));
}

} // namespace

std::vector<Eigen::Quaterniond> poseCorrections(const PosedSurface& reference, const PosedMesh& target,
                                                std::span<const TrianglePair> pairs)
{
    const std::size_t count = pairs.size();
    std::vector<Eigen::Quaterniond> corrections(count, Eigen::Quaterniond::Identity());
    const std::vector<Vec3d> from = middlesOf(reference.mesh(), pairs, &TrianglePair::onTemplate);
    const std::vector<Vec3d> onto = middlesOf(target, pairs, &TrianglePair::onTarget);
    const double spreadFrom = spreadOf(from).size;
    const double spread = spreadOf(onto).size;
    if (count < fewestPairs || spreadFrom == 0 || spread == 0 || areMirrored(from, onto))
        return corrections;
    std::vector<TriangleIndex> marks;
    std::vector<PliableSurface::Anchor> anchors;
    for (std::size_t m = 0; m < count; ++m) {
        const Triangle& onTarget = target.topology->triangles()[pairs[m].onTarget.value];
        marks.push_back(pairs[m].onTemplate);
        anchors.push_back({m, onto[m], normalOf(onTarget, target.positions), 1});
    }
    PliableSurface surface(reference, std::move(marks));
    surface.scale(spread / spreadFrom);
    for (int look = 0; look < markLooks; ++look) {
        for (PliableSurface::Anchor& anchor : anchors) {
            anchor.share =
                look < looksAtNone ? 1 : surface.nearness(anchor.place, anchor.position, halfMiss * spread);
        }
        surface.settle(anchors, roundsALook);
    }
    for (std::size_t m = 0; m < count; ++m)
        corrections[m] = withoutSmallTurns(Eigen::Quaterniond(surface.turn(m)).conjugate());
    return corrections;
}

} // namespace quadrille
