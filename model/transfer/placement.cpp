// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/placement.h"

#include "model/core/smoothing.h"
#include "model/synthesis/clips/ground.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace quadrille {

namespace {

/// What stands reaches so high above the lowest vertex, heights of the target.
constexpr double soleHeight = 0.015;
/// The template must have come so far while it stood, heights of the target, for its steps to tell a scale.
constexpr double leastWay = 0.6;
/// Legs differ from one body to another by no more against their heights.
constexpr double widestLegs = 1.25;
/// Of the time over which heights are evened out, seconds.
constexpr double heightDeviation = 0.06;

double lowestOf(Positions pose, Eigen::Index up)
{
    float lowest = std::numeric_limits<float>::infinity();
    for (const Vec3f& p : pose)
        lowest = std::min(lowest, p[up]);
    return static_cast<double>(lowest);
}

double heightOf(Positions pose, Eigen::Index up)
{
    const auto [low, high] = std::ranges::minmax_element(pose, {}, [&](const Vec3f& p) { return p[up]; });
    return static_cast<double>((*high)[up] - (*low)[up]);
}

} // namespace

double groundOf(const TemplateCourse& course)
{
    std::vector<double> heights;
    for (std::size_t f = 0; f < course.lowest.size(); ++f) {
        if (course.stands[f] != 0)
            heights.push_back(course.lowest[f]);
    }
    if (heights.empty())
        return *std::ranges::min_element(course.lowest);
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::ranges::nth_element(heights, middle);
    return *middle;
}

std::vector<std::uint8_t> standingFrames(std::span<const ContactSpan> contacts, std::int64_t frames)
{
    std::vector<std::uint8_t> stands(static_cast<std::size_t>(frames), 0);
    for (const ContactSpan& contact : contacts) {
        const std::int64_t last = std::min(contact.frames.last.value, frames - 1);
        for (std::int64_t f = std::max<std::int64_t>(contact.frames.first.value, 0); f <= last; ++f)
            stands[static_cast<std::size_t>(f)] = 1;
    }
    return stands;
}

std::optional<Vec3d> wayOfSoles(Positions before, Positions after, UpAxis up)
{
    const auto upward = static_cast<Eigen::Index>(up);
    const double reach = soleHeight * heightOf(before, upward);
    const double limitBefore = lowestOf(before, upward) + reach;
    const double limitAfter = lowestOf(after, upward) + reach;
    Vec3d sum = Vec3d::Zero();
    int count = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
        if (static_cast<double>(before[v][upward]) > limitBefore ||
            static_cast<double>(after[v][upward]) > limitAfter)
            continue;
        sum += (after[v] - before[v]).cast<double>();
        ++count;
    }
    return count > 0 ? std::optional<Vec3d>(sum / count) : std::nullopt;
}

double scaleOfSteps(const TemplateCourse& course, const PosedTarget& target, UpAxis up, double usual)
{
    const Ground ground(up);
    const double height = heightOf(target.at(0), ground.upAxis());
    double product = 0;
    double square = 0;
    double way = 0;
    for (std::size_t f = 0; f + 1 < target.count(); ++f) {
        if (course.stands[f] == 0 || course.stands[f + 1] == 0)
            continue;
        const auto soles = wayOfSoles(target.at(f), target.at(f + 1), up);
        if (!soles)
            continue;
        const Vec3d slide = course.slides.empty() ? Vec3d::Zero() : course.slides[f];
        const Vec2d root = ground.of(course.middles[f + 1] - course.middles[f] - slide);
        product -= root.dot(ground.of(*soles));
        square += root.squaredNorm();
        way += root.norm();
    }
    if (way < leastWay * height)
        return usual;
    return std::clamp(product / square, usual / widestLegs, usual * widestLegs);
}

Vec3d placeOf(const TemplateCourse& course, std::size_t frame, double scale, UpAxis up, Positions pose)
{
    const Eigen::Index upward = Ground(up).upAxis();
    const Vec3d& begin = course.middles.front();
    Vec3d place = begin + scale * (course.middles[frame] - begin);
    place[upward] = course.ground + scale * (course.lowest[frame] - course.ground) - lowestOf(pose, upward);
    return place;
}

void placeOnGround(const TemplateCourse& course, double scale, UpAxis up, const PosedTarget& target)
{
    const Eigen::Index upward = Ground(up).upAxis();
    std::vector<Vec3d> places;
    std::vector<double> unevenness; // by what heights lie over the template's way
    for (std::size_t f = 0; f < target.count(); ++f) {
        places.push_back(placeOf(course, f, scale, up, target.at(f)));
        unevenness.push_back(places[f][upward] - scale * course.middles[f][upward]);
    }
    unevenness = evened(unevenness, heightDeviation * course.fps);
    for (std::size_t f = 0; f < target.count(); ++f) {
        places[f][upward] = unevenness[f] + scale * course.middles[f][upward];
        for (Vec3f& p : target.at(f))
            p += places[f].cast<float>();
    }
}

} // namespace quadrille
