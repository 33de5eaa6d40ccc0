// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/spacetake.h"

#include "model/variation/alignposes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace quadrille {

namespace {

/// Frames of a take over the ground.
struct StandingFrames
{
    std::vector<Vec3f> poses;
    std::vector<GroundMotion> places;

    Positions pose(std::size_t frame) const
    {
        const std::size_t vertices = poses.size() / places.size();
        return Positions(poses).subspan(frame * vertices, vertices);
    }
};

/// A placement's turn about the up axis and its way over the ground; the rest stays with the pose.
StandingFrames standing(const AlignedTake& take, const Ground& ground)
{
    StandingFrames frames{.poses = take.poses, .places = {}};
    const std::size_t vertices = take.poses.size() / take.placements.size();
    for (std::size_t f = 0; f < take.placements.size(); ++f) {
        const RigidMotion& place = take.placements[f];
        const Eigen::Quaterniond& q = place.rotation;
        const double turn = wrappedAngle(2 * std::atan2(q.vec()[ground.upAxis()], q.w()));
        const Eigen::Matrix3f tilt =
            (Eigen::AngleAxisd(-turn, ground.up()) * q).toRotationMatrix().cast<float>();
        const Vec3f height = (ground.heightOf(place.translation) * ground.up()).cast<float>();
        for (Vec3f& p : std::span(frames.poses).subspan(f * vertices, vertices))
            p = tilt * p + height;
        frames.places.push_back({turn, ground.of(place.translation)});
    }
    return frames;
}

/// The warp with up to two frames of the take after its last one.
TakeWarp withFramesAfter(TakeWarp warp, std::int64_t takeFrames)
{
    const std::int64_t count = std::min<std::int64_t>(2, takeFrames - 1 - warp.frames.last.value);
    if (count > 0)
        warp.positions.push_back(warp.positions.back() + 1);
    if (count > 1)
        warp.positions.push_back(std::min(warp.positions.back() + warp.positions[1] - warp.positions[0],
                                          static_cast<double>(takeFrames - 1)));
    warp.frames.last.value += count;
    return warp;
}

/// Takes the difference of the frame after the last to the first one out of the frames of a cycle: that of
/// places over all of it, that of speeds beside the seam. Speeds that differ for a moment, as where a foot
/// lands a frame earlier, would carry the foot away from the body if they were evened out over a whole cycle.
class SeamCorrection
{
public:
    /// \param place  of a vertex: first frame less frame after the last. \param speed  likewise of what it
    /// moves by in a frame.
    SeamCorrection(std::vector<Vec3f> place, std::vector<Vec3f> speed, std::size_t frames)
        : m_place(std::move(place))
        , m_speed(std::move(speed))
        , m_frames(static_cast<float>(frames))
        , m_reach(std::max(m_frames * shareBesideSeam, leastBesideSeam))
    {
    }

    void correct(std::size_t frame, MutablePositions pose) const
    {
        // Hermite's cubics: of places from −1/2 to 1/2, of half of the speeds from the seam to where it ends.
        const auto f = static_cast<float>(frame);
        const float u = f / m_frames;
        const float ofPlace = u * u * (3 - 2 * u) - 0.5F;
        const float far = std::min(f, m_frames - f) / m_reach;
        const float ofSpeed = far < 1 ? -m_reach * far * (1 - far) * (1 - far) / 2 : 0;
        for (std::size_t v = 0; v < pose.size(); ++v)
            pose[v] += ofPlace * m_place[v] + ofSpeed * m_speed[v];
    }

private:
    static constexpr float shareBesideSeam = 0.125F; ///< of the cycle, on each side
    static constexpr float leastBesideSeam = 2;      ///< frames

    std::vector<Vec3f> m_place;
    std::vector<Vec3f> m_speed;
    float m_frames;
    float m_reach; ///< frames on each side in which speeds become one
};

std::vector<Vec3f> difference(Positions a, Positions b)
{
    std::vector<Vec3f> result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(),
                   [](const Vec3f& x, const Vec3f& y) { return Vec3f(x - y); });
    return result;
}

SeamCorrection seamOf(const StandingFrames& frames, std::size_t count)
{
    const std::size_t after = frames.places.size() - count;
    const std::vector<Vec3f> first = difference(frames.pose(1), frames.pose(0));
    if (after > 1)
        return {difference(frames.pose(0), frames.pose(count)),
                difference(first, difference(frames.pose(count + 1), frames.pose(count))), count};
    const std::vector<Vec3f> none(first.size(), Vec3f::Zero());
    if (after == 1)
        return {difference(frames.pose(0), frames.pose(count)), none, count};
    std::vector<Vec3f> place = difference(frames.pose(0), frames.pose(count - 1));
    const std::vector<Vec3f> last = difference(frames.pose(count - 1), frames.pose(count - 2));
    for (std::size_t v = 0; v < place.size(); ++v)
        place[v] -= last[v];
    return {std::move(place), none, count};
}

} // namespace

SpaceTake makeSpaceTake(const MeshSequence& sequence, const AlignedTake& aligned,
                        const SpaceTakeOptions& options, const Progress& progress)
{
    const std::size_t count = aligned.warp.positions.size();
    assert(count >= 3);
    const Ground ground(options.up);
    AlignedTake laid{.name = aligned.name,
                     .warp = options.isCyclic ? withFramesAfter(aligned.warp, sequence.frameCount())
                                              : aligned.warp,
                     .poses = {},
                     .placements = {},
                     .laidOnto = aligned.laidOnto};
    alignPoses(sequence, laid, progress);
    StandingFrames frames = standing(laid, ground);

    SpaceTake take{.name = aligned.name, .warp = aligned.warp, .poses = {}, .steps = {}, .seconds = {}};
    for (std::size_t f = 0; f + 1 < frames.places.size() && f < count; ++f) {
        GroundMotion step = frames.places[f].inverse() * frames.places[f + 1];
        step.turn = wrappedAngle(step.turn);
        take.steps.push_back(step);
        take.seconds.push_back((laid.warp.positions[f + 1] - laid.warp.positions[f]) /
                               (sequence.fps * options.speed));
    }
    if (take.steps.size() < count) { // nothing is known of what comes after the last frame
        take.steps.push_back(take.steps.back());
        take.seconds.push_back(take.seconds.back());
    }
    if (options.isCyclic) {
        const SeamCorrection seam = seamOf(frames, count);
        const std::size_t vertices = frames.poses.size() / frames.places.size();
        for (std::size_t f = 0; f < count; ++f)
            seam.correct(f, MutablePositions(frames.poses).subspan(f * vertices, vertices));
    }
    frames.poses.resize(count * (frames.poses.size() / frames.places.size()));
    take.poses = std::move(frames.poses);
    return take;
}

} // namespace quadrille
