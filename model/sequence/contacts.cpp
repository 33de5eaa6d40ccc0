// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/contacts.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace quadrille {

namespace {

/// Positions with y up: frames × vertices.
struct Frames
{
    std::vector<Vec3f> positions;
    std::size_t vertices = 0;

    std::size_t count() const { return vertices == 0 ? 0 : positions.size() / vertices; }
    Positions at(std::size_t frame) const { return Positions(positions).subspan(frame * vertices, vertices); }
};

Frames loadUpright(const MeshSequence& sequence, UpAxis up, const Progress& progress)
{
    Frames frames;
    frames.vertices = sequence.source->vertexCount();
    frames.positions = loadFrames(sequence, progress);
    const Eigen::Matrix3f matrix = conversionMatrix({.up = up}, {.up = UpAxis::Y});
    if (matrix != Eigen::Matrix3f::Identity())
        for (Vec3f& p : frames.positions)
            p = matrix * p;
    return frames;
}

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
float groundLevel(const Frames& frames)
{
    std::vector<float> levels;
    for (std::size_t f = 0; f < frames.count(); ++f)
        levels.push_back(lowest(frames.at(f)));
    std::sort(levels.begin(), levels.end());
    return levels[levels.size() / 5];
}

/// The frame in which the figure is tallest: upright, with its feet below it.
std::size_t tallestFrame(const Frames& frames, float ground)
{
    std::size_t best = 0;
    float tallest = -std::numeric_limits<float>::max();
    for (std::size_t f = 0; f < frames.count(); ++f) {
        const float low = lowest(frames.at(f));
        const float height = highest(frames.at(f)) - low - 2 * std::abs(low - ground);
        if (height > tallest) {
            tallest = height;
            best = f;
        }
    }
    return best;
}

Vec3f mean(Positions positions, const std::vector<std::uint32_t>& of)
{
    Vec3f sum = Vec3f::Zero();
    for (const std::uint32_t v : of)
        sum += positions[v];
    return sum / static_cast<float>(std::max<std::size_t>(of.size(), 1));
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

struct Foot
{
    std::string name;
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> ankle; ///< the ring of vertices above
};

/// Feet lie ahead of ankles; over all frames this tells which of two is the left one.
bool isLeftFirst(const Frames& frames, const std::vector<Foot>& feet)
{
    float leftness = 0;
    for (std::size_t f = 0; f < frames.count(); ++f) {
        const Positions p = frames.at(f);
        const Vec3f one = mean(p, feet[0].vertices);
        const Vec3f two = mean(p, feet[1].vertices);
        const Vec3f ahead = one - mean(p, feet[0].ankle) + two - mean(p, feet[1].ankle);
        leftness += Vec3f::UnitY().cross(ahead).dot(one - two);
    }
    return leftness > 0;
}

/// The feet, in the frame in which the figure is tallest; nothing when it stands on one piece.
std::vector<Foot> findFeet(const MeshSequence& sequence, const Frames& frames, Positions tallest,
                           float bodyHeight, double share)
{
    const float low = lowest(tallest);
    // Knee-high pieces of the mesh are the lower legs, also while one heel is up.
    const auto legs = piecesBelow(*sequence.topology, tallest, low + 0.22F * bodyHeight);
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
        const bool leftFirst = isLeftFirst(frames, feet);
        feet[0].name = leftFirst ? "left" : "right";
        feet[1].name = leftFirst ? "right" : "left";
        return feet;
    }
    for (std::size_t i = 0; i < feet.size(); ++i)
        feet[i].name = "foot " + std::to_string(i + 1);
    return feet;
}

/// Captured soles rarely lie at one level, so each foot rests where its own lowest part does in a good share
/// of the frames, within a little of the common ground.
void setToOwnGround(std::vector<float>& heights, float most)
{
    std::vector<float> sorted = heights;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 6);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const float own = std::clamp(*middle, -most, most);
    for (float& height : heights)
        height -= own;
}

/// Height above the ground and speed of a foot's lowest part, per frame; body heights, per second.
struct FootTrack
{
    std::vector<float> heights;
    std::vector<float> speeds;
};

FootTrack trackFoot(const Frames& frames, const std::vector<std::uint32_t>& foot, float ground,
                    float bodyHeight, double fps)
{
    const std::size_t count = frames.count();
    FootTrack track;
    for (std::size_t f = 0; f < count; ++f) {
        const Positions now = frames.at(f);
        std::vector<std::uint32_t> order = foot;
        const auto kept = static_cast<std::ptrdiff_t>(std::max<std::size_t>(3, foot.size() / 6));
        std::nth_element(order.begin(), order.begin() + kept - 1, order.end(), [&now](auto a, auto b) {
            return std::pair(now[a].y(), a) < std::pair(now[b].y(), b);
        });
        order.resize(static_cast<std::size_t>(kept));
        track.heights.push_back((mean(now, order).y() - ground) / bodyHeight);
        const Positions before = frames.at(f == 0 ? 0 : f - 1);
        const Positions after = frames.at(std::min(f + 1, count - 1));
        // The slower of before and after: the first and last frame of a contact count as standing.
        const float back = (mean(now, order) - mean(before, order)).norm();
        const float ahead = (mean(after, order) - mean(now, order)).norm();
        const float step = f == 0 ? ahead : f + 1 == count ? back : std::min(back, ahead);
        track.speeds.push_back(step * static_cast<float>(fps) / bodyHeight);
    }
    setToOwnGround(track.heights, 0.017F);
    return track;
}

std::vector<FrameRange> standingSpans(const FootTrack& track, const ContactOptions& options, double fps)
{
    std::vector<FrameRange> spans;
    bool stands = false;
    const auto count = static_cast<std::int64_t>(track.heights.size());
    for (std::int64_t f = 0; f < count; ++f) {
        const double height = track.heights[static_cast<std::size_t>(f)];
        const double speed = track.speeds[static_cast<std::size_t>(f)];
        const bool continues = stands && height < options.leaveHeight && speed < options.leaveSpeed;
        const bool begins = height < options.landHeight && speed < options.landSpeed;
        const bool now = continues || begins;
        if (now && !stands) {
            const bool joins = !spans.empty() && static_cast<double>(f - spans.back().last.value - 1) <=
                                                     options.longestGap * fps;
            if (!joins)
                spans.push_back({FrameIndex(f), FrameIndex(f)});
        }
        stands = now;
        if (now)
            spans.back().last = FrameIndex(f);
    }
    std::erase_if(spans, [&](const FrameRange& span) {
        return static_cast<double>(span.count()) < options.shortest * fps;
    });
    return spans;
}

void checkOptions(const ContactOptions& o)
{
    const bool isGood = o.landHeight > 0 && o.landSpeed > 0 && o.leaveHeight >= o.landHeight &&
                        o.leaveSpeed >= o.landSpeed && o.shortest >= 0 && o.longestGap >= 0 &&
                        o.footShare > 0 && o.footShare < 0.2;
    if (!isGood)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", QUADRILLE_MESSAGE("Limits of foot contacts must be positive, those for "
                                                   "leaving not below those for landing")},
                      {"remedy", QUADRILLE_MESSAGE("Correct the limits.")}}});
}

} // namespace

std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options,
                                        const Progress& progress)
{
    checkOptions(options);
    progress.report(0.0);
    if (sequence.frameCount() < 2)
        return {};
    const Frames frames = loadUpright(sequence, options.up, progress.part(0, 0.6));
    const float ground = groundLevel(frames);
    const Positions tallest = frames.at(tallestFrame(frames, ground));
    const float bodyHeight = highest(tallest) - lowest(tallest);
    if (!(bodyHeight > 0))
        return {};
    const std::vector<Foot> feet = findFeet(sequence, frames, tallest, bodyHeight, options.footShare);
    std::vector<ContactSpan> spans;
    for (std::size_t i = 0; i < feet.size(); ++i) {
        progress.report(0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(feet.size()));
        const FootTrack track = trackFoot(frames, feet[i].vertices, ground, bodyHeight, sequence.fps);
        for (const FrameRange& range : standingSpans(track, options, sequence.fps))
            spans.push_back({feet[i].name, range});
    }
    std::stable_sort(spans.begin(), spans.end(), [](const ContactSpan& a, const ContactSpan& b) {
        return a.frames.first < b.frames.first;
    });
    progress.report(1.0);
    return spans;
}

} // namespace quadrille
