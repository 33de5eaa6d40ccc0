// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/feet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

namespace quadrille {

namespace {

float lowest(Positions positions)
{
    float y = std::numeric_limits<float>::max();
    for (const Vec3f& p : positions)
        y = std::min(y, p.y());
    return y;
}

float highest(Positions positions)
{
    float y = -std::numeric_limits<float>::max();
    for (const Vec3f& p : positions)
        y = std::max(y, p.y());
    return y;
}

/// The level on which the figure stands: most frames' lowest points lie at or just above it.
float groundLevel(const UprightFrames& frames)
{
    std::vector<float> levels;
    for (std::size_t f = 0; f < frames.count(); ++f)
        levels.push_back(lowest(frames.at(f)));
    std::sort(levels.begin(), levels.end());
    return levels[levels.size() / 5];
}

/// The frames in which the figure is upright, with its feet below it: those in which it is nearly as tall as
/// it gets, the tallest first.
std::vector<std::size_t> tallFrames(const UprightFrames& frames, float ground)
{
    constexpr float nearlyAsTall = 0.95F;
    std::vector<std::pair<float, std::size_t>> heights;
    for (std::size_t f = 0; f < frames.count(); ++f) {
        const float low = lowest(frames.at(f));
        heights.emplace_back(highest(frames.at(f)) - low - 2 * std::abs(low - ground), f);
    }
    std::ranges::stable_sort(heights, std::greater(), &std::pair<float, std::size_t>::first);
    std::vector<std::size_t> tall;
    for (const auto& [height, frame] : heights) {
        if (tall.empty() || height >= nearlyAsTall * heights.front().first)
            tall.push_back(frame);
    }
    return tall;
}

/// Vertices of the shanks up to a height along the mesh: grows from the lowest vertex over edges.
std::vector<std::vector<std::uint32_t>> piecesBelow(const Topology& topology, Positions positions,
                                                    float level)
{
    std::vector<std::uint32_t> root(positions.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&root](std::uint32_t v) {
        while (root[v] != v)
            v = root[v] = root[root[v]];
        return v;
    };
    for (const Triangle& t : topology.triangles())
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = t[c].value;
            const std::uint32_t b = t[(c + 1) % 3].value;
            if (positions[a].y() < level && positions[b].y() < level)
                root[find(a)] = find(b);
        }
    std::vector<std::vector<std::uint32_t>> pieces(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v)
        if (positions[v].y() < level)
            pieces[find(v)].push_back(v);
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return pieces;
}

Vec3f centreOf(Positions positions)
{
    Vec3f sum = Vec3f::Zero();
    for (const Vec3f& p : positions)
        sum += p;
    return sum / static_cast<float>(positions.size());
}

/// Where a figure goes that runs, as long as its feet lie ahead of its ankles together; nothing where it is
/// no faster than somebody may go backwards or to a side.
std::optional<Vec3f> aheadOfRunner(const UprightFrames& frames, std::size_t frame, float bodyHeight)
{
    constexpr double leastSpeed = 0.9;       // body heights a second
    constexpr float lengthOfBothFeet = 0.1F; // body heights
    const std::size_t before = frame > 0 ? frame - 1 : 0;
    const std::size_t after = std::min(frame + 1, frames.count() - 1);
    Vec3f way = centreOf(frames.at(after)) - centreOf(frames.at(before));
    way.y() = 0;
    const double seconds = static_cast<double>(after - before) / std::max(frames.fps, 1.0);
    if (frames.fps <= 0 ||
        static_cast<double>(way.norm()) <= leastSpeed * seconds * static_cast<double>(bodyHeight))
        return std::nullopt;
    return lengthOfBothFeet * bodyHeight * way.normalized();
}

/// Feet lie ahead of ankles, but for those of runners, which are swung behind; over all frames this tells
/// which of two is the left one.
bool isLeftFirst(const UprightFrames& frames, const std::vector<Foot>& feet, float bodyHeight)
{
    float leftness = 0;
    for (std::size_t f = 0; f < frames.count(); ++f) {
        const Positions p = frames.at(f);
        const Vec3f one = meanOf(p, feet[0].vertices);
        const Vec3f two = meanOf(p, feet[1].vertices);
        const Vec3f ofFeet = one - meanOf(p, feet[0].ankle) + two - meanOf(p, feet[1].ankle);
        const Vec3f ahead = aheadOfRunner(frames, f, bodyHeight).value_or(ofFeet);
        leftness += Vec3f::UnitY().cross(ahead).dot(one - two);
    }
    return leftness > 0;
}

/// The feet, in a frame in which the figure stands upright; nothing when it stands on one piece.
std::vector<Foot> findFeet(const Topology& topology, const UprightFrames& frames, Positions tallest,
                           float bodyHeight, double share)
{
    const float low = lowest(tallest);
    // Knee-high pieces of the mesh are the lower legs, also while one heel is up.
    const auto legs = piecesBelow(topology, tallest, low + 0.22F * bodyHeight);
    const auto height = static_cast<float>(share) * bodyHeight;
    std::vector<Foot> feet;
    for (const auto& leg : legs) {
        if (leg.size() < 4 || leg.size() * 3 < legs.front().size())
            break;
        float sole = std::numeric_limits<float>::max();
        for (const std::uint32_t v : leg)
            sole = std::min(sole, tallest[v].y());
        Foot foot;
        for (const std::uint32_t v : leg) {
            const float above = tallest[v].y() - sole;
            if (above < height)
                foot.vertices.push_back(v);
            else if (above < 1.6F * height)
                foot.ankle.push_back(v);
        }
        if (!foot.ankle.empty())
            feet.push_back(std::move(foot));
    }
    if (feet.size() < 2)
        return {};
    if (feet.size() == 2) {
        const bool leftFirst = isLeftFirst(frames, feet, bodyHeight);
        feet[0].name = leftFirst ? "left" : "right";
        feet[1].name = leftFirst ? "right" : "left";
        return feet;
    }
    for (std::size_t i = 0; i < feet.size(); ++i)
        feet[i].name = "foot " + std::to_string(i + 1);
    return feet;
}

} // namespace

UprightFrames upright(std::vector<Vec3f> positions, std::size_t vertices, UpAxis up)
{
    const Eigen::Matrix3f matrix = conversionMatrix({.up = up}, {.up = UpAxis::Y});
    if (matrix != Eigen::Matrix3f::Identity())
        for (Vec3f& p : positions)
            p = matrix * p;
    return {.positions = std::move(positions), .vertices = vertices};
}

UprightFrames loadUpright(const MeshSequence& sequence, UpAxis up, const Progress& progress)
{
    UprightFrames frames = upright(loadFrames(sequence, progress), sequence.source->vertexCount(), up);
    frames.fps = sequence.fps;
    return frames;
}

Vec3f meanOf(Positions positions, const std::vector<std::uint32_t>& of)
{
    Vec3f sum = Vec3f::Zero();
    for (const std::uint32_t v : of)
        sum += positions[v];
    return sum / static_cast<float>(std::max<std::size_t>(of.size(), 1));
}

Figure findFigure(const Topology& topology, const UprightFrames& frames, double footShare)
{
    Figure figure;
    if (frames.count() == 0)
        return figure;
    figure.ground = groundLevel(frames);
    const std::vector<std::size_t> tall = tallFrames(frames, figure.ground);
    // Where it is tallest it may stand on one leg: in the middle of a step, or of a kick.
    constexpr std::size_t mostTried = 30;
    const std::size_t step = (tall.size() + mostTried - 1) / mostTried;
    for (std::size_t i = 0; i < tall.size() && figure.feet.empty(); i += step) {
        const Positions pose = frames.at(tall[i]);
        const float height = highest(pose) - lowest(pose);
        if (height > 0)
            figure.feet = findFeet(topology, frames, pose, height, footShare);
        if (i == 0 || !figure.feet.empty()) {
            figure.tallest = tall[i];
            figure.height = height;
        }
    }
    return figure;
}

Legs findLegs(const Topology& topology, const UprightFrames& frames, double footShare)
{
    Figure figure = findFigure(topology, frames, footShare);
    if (figure.feet.empty())
        return {};
    const Positions pose = frames.at(figure.tallest);
    const float low = lowest(pose);
    const auto pieceOf = [&](const Foot& foot, float share) {
        for (auto& piece : piecesBelow(topology, pose, low + share * figure.height)) {
            if (std::ranges::binary_search(piece, foot.vertices.front()))
                return std::move(piece);
        }
        return std::vector<std::uint32_t>();
    };
    Legs legs{.feet = {},
              .vertices = {},
              .height = static_cast<double>(figure.height),
              .reference = {pose.begin(), pose.end()}};
    for (const Foot& foot : figure.feet) {
        const auto isAlone = [&](const std::vector<std::uint32_t>& piece) {
            return std::ranges::none_of(figure.feet, [&](const Foot& other) {
                return &other != &foot && std::ranges::binary_search(piece, other.vertices.front());
            });
        };
        float apart = 0.22F;
        float together = 0.6F;
        for (int step = 0; step < 8; ++step) {
            const float share = (apart + together) / 2;
            (isAlone(pieceOf(foot, share)) ? apart : together) = share;
        }
        legs.vertices.push_back(pieceOf(foot, apart));
    }
    legs.feet = std::move(figure.feet);
    return legs;
}

} // namespace quadrille
