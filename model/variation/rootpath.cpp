// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/rootpath.h"

#include "model/core/smoothing.h"
#include "model/synthesis/clips/ground.h"
#include "model/variation/preblend.h"
#include "model/variation/resampling.h"
#include "model/variation/samemovement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

constexpr double guessedHeading = 4 * std::numbers::pi / 180;
constexpr double guessedShareOfTurn = 0.1;
constexpr double guessedShareOfWay = 0.05;
constexpr double guessedTempo = 0.025;

/// Standard deviation of the Gaussian by which differences of displacements are evened out, seconds.
constexpr double eveningOfWay = 0.2;

using SixRow = Eigen::Matrix<double, 1, 6>;

/// Heading and place over the ground, seen from the first placement.
std::vector<GroundMotion> courseOf(std::span<const RigidMotion> placements, const Ground& ground)
{
    std::vector<GroundMotion> course;
    const Vec3d up = ground.up();
    const auto headingOf = [&](const RigidMotion& place) {
        const Eigen::Quaterniond turned = place.rotation * placements.front().rotation.conjugate();
        return wrappedAngle(2 * std::atan2(turned.vec().dot(up), turned.w()));
    };
    const Vec2d first = ground.of(placements.front().translation);
    for (const RigidMotion& place : placements) {
        double turn = headingOf(place);
        if (!course.empty()) // beyond half a turn it goes on
            turn = course.back().turn + wrappedAngle(turn - course.back().turn);
        course.push_back({turn, ground.of(place.translation) - first});
    }
    return course;
}

struct Apart
{
    double heading = 0;
    double way = 0;
};

/// How far two courses are apart at most. \param turn  by which the second is turned to begin as the first.
Apart apart(std::span<const GroundMotion> a, std::span<const GroundMotion> b, double turn)
{
    Apart most;
    for (std::size_t f = 0; f < a.size(); ++f) {
        most.heading = std::max(most.heading, std::abs(a[f].turn - b[f].turn));
        most.way = std::max(most.way, (a[f].shift - Eigen::Rotation2Dd(turn) * b[f].shift).norm());
    }
    return most;
}

/// The turn about the up axis from the first placement of one path to that of another.
double turnBetween(const RigidMotion& from, const RigidMotion& to, const Ground& ground)
{
    const Eigen::Quaterniond turned = to.rotation * from.rotation.conjugate();
    return wrappedAngle(2 * std::atan2(turned.vec().dot(ground.up()), turned.w()));
}

WayRange rangeAround(const Movement& movement, std::size_t take, const Ground& ground)
{
    const AlignedTake& own = movement.take(take);
    const std::vector<GroundMotion> course = courseOf(own.placements, ground);
    WayRange range;
    double logSquares = 0;
    int others = 0;
    const auto durationOf = [](const AlignedTake& each) {
        return std::log(static_cast<double>(each.warp.frames.count()));
    };
    for (const std::size_t other : sameMovement(movement, take)) {
        if (other == take)
            continue;
        const AlignedTake& each = movement.take(other);
        const Apart most = apart(course, courseOf(each.placements, ground),
                                 turnBetween(each.placements.front(), own.placements.front(), ground));
        range.heading += most.heading;
        range.way += most.way;
        logSquares += std::pow(durationOf(each) - durationOf(own), 2);
        ++others;
    }
    if (others > 0) {
        // The distance of two that vary as much is √2 as large as that of one from their mean.
        const double share = 1 / (std::numbers::sqrt2 * others);
        return {range.heading * share, range.way * share, std::sqrt(logSquares / others / 2)};
    }
    double length = 0;
    for (std::size_t f = 1; f < course.size(); ++f)
        length += (course[f].shift - course[f - 1].shift).norm();
    return {guessedHeading + guessedShareOfTurn * std::abs(course.back().turn), guessedShareOfWay * length,
            guessedTempo};
}

} // namespace

WayRange wayRange(const Movement& movement, const VariationSubject& subject, UpAxis up)
{
    const Ground ground(up);
    WayRange range;
    for (const BlendShare& each : capturedShares(movement, subject)) {
        const WayRange own = rangeAround(movement, each.take, ground);
        range.heading += each.share * own.heading;
        range.way += each.share * own.way;
        range.tempo += each.share * own.tempo;
    }
    return range;
}

std::vector<RigidMotion> boundedPath(std::span<const Displacement> displacements,
                                     std::span<const RigidMotion> guide, const WayRange& range,
                                     const PathSettings& settings)
{
    assert(displacements.size() == guide.size());
    const Ground ground(settings.up);
    const std::vector<Displacement> own = displacementsOf(guide);
    std::vector<SixRow> changes;
    for (std::size_t f = 0; f < own.size(); ++f)
        changes.push_back(SixRow::Map(displacements[f].data()) - SixRow::Map(own[f].data()));
    changes = evened(changes, eveningOfWay * settings.fps);
    const auto changed = [&](double way, double turn) {
        std::vector<Displacement> steps = own;
        for (std::size_t f = 0; f < steps.size(); ++f) {
            for (std::size_t i = 0; i < steps[f].size(); ++i)
                steps[f][i] += (i < 3 ? way : turn) * changes[f][static_cast<Eigen::Index>(i)];
        }
        return pathOnGround(steps, guide, settings);
    };
    const auto shareWithin = [](double most, double bound) { return most > bound ? bound / most : 1; };
    const std::vector<GroundMotion> course = courseOf(guide, ground);
    const double turn = shareWithin(apart(course, courseOf(changed(0, 1), ground), 0).heading, range.heading);
    const std::vector<GroundMotion> turned = courseOf(changed(0, turn), ground);
    const double way = shareWithin(apart(turned, courseOf(changed(1, turn), ground), 0).way, range.way);
    return changed(way, turn);
}

namespace {

/// The tempo of what stands, if the whole is to have a tempo and what flies keeps its own. Logarithms of
/// durations' factors. \param share  of the time that something stands.
double tempoOfStanding(double tempo, double share)
{
    constexpr double greatest = 0.15; // at so much quicker, accelerations are a third higher
    const double factor = share > 0 ? (std::exp(tempo) - 1 + share) / share : 1;
    return std::clamp(std::log(std::max(factor, std::exp(-greatest))), -greatest, greatest);
}

} // namespace

TempoPlayback inTempo(const std::vector<double>& playback, const std::vector<bool>& stands, double tempo)
{
    assert(stands.size() == playback.size());
    constexpr std::int64_t least = 4; // frames
    constexpr double evening = 2;     // frames
    TempoPlayback result;
    if (tempo == 0 || playback.size() < 2) {
        result.positions = playback;
        for (std::size_t k = 0; k < playback.size(); ++k)
            result.nearest.push_back(k);
        return result;
    }
    const auto standing = [&](std::size_t k) {
        return 0.5 * ((stands[k - 1] ? 1 : 0) + (stands[k] ? 1 : 0));
    };
    double share = 0;
    for (std::size_t k = 1; k < stands.size(); ++k)
        share += standing(k) / static_cast<double>(stands.size() - 1);
    const double own = tempoOfStanding(tempo, share);
    std::vector<double> times{0};
    for (std::size_t k = 1; k < stands.size(); ++k)
        times.push_back(times.back() + std::exp(own * standing(k)));
    times = evened(times, evening);
    const std::int64_t frames = std::max<std::int64_t>(std::llround(times.back()) + 1, least);
    const double stretch = static_cast<double>(frames - 1) / times.back();
    for (double& time : times)
        time *= stretch;
    for (const double at : inverseWarp(times, 0, frames)) {
        const FramesAround around = framesAround(at, playback.size());
        result.positions.push_back(
            std::lerp(playback[around.before()], playback[around.after()], around.share));
        result.nearest.push_back(around.share < 0.5 ? around.before() : around.after());
    }
    return result;
}

} // namespace quadrille
