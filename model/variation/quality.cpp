// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/quality.h"

#include "model/core/bounds.h"
#include "model/synthesis/quality/framemeasures.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

std::vector<Positions> posesOf(std::span<const AlignedTake> takes, std::size_t vertexCount)
{
    std::vector<Positions> poses;
    for (const AlignedTake& take : takes) {
        for (std::size_t at = 0; at < take.poses.size(); at += vertexCount)
            poses.push_back(Positions(take.poses).subspan(at, vertexCount));
    }
    return poses;
}

double lowestOf(Positions pose, UpAxis up)
{
    const auto upwards = static_cast<Eigen::Index>(up);
    float lowest = pose.front()[upwards];
    for (const Vec3f& position : pose)
        lowest = std::min(lowest, position[upwards]);
    return static_cast<double>(lowest);
}

/// Mean of the values that are there.
std::optional<double> meanOfKnown(std::span<const std::optional<double>> values)
{
    double sum = 0;
    int count = 0;
    for (const std::optional<double>& value : values) {
        sum += value.value_or(0);
        count += value ? 1 : 0;
    }
    return count > 0 ? std::optional(sum / count) : std::nullopt;
}

} // namespace

std::string_view toString(VariationFault fault)
{
    constexpr std::array<std::string_view, variationFaults> names{
        "pose-distance", "foot-skate", "intersections", "volume", "collapse", "ground"};
    return names[static_cast<std::size_t>(fault)];
}

double greatestPoseDistance(const VariationQuality& quality, const VariationLimits& limits)
{
    if (limits.poseDistance)
        return *limits.poseDistance * quality.size;
    return std::max(quality.takeDistance, leastPoseDistance * quality.size);
}

std::vector<VariationFault> judge(const VariationQuality& quality, const VariationLimits& limits)
{
    std::vector<VariationFault> faults;
    if (quality.worstPoseDistance > greatestPoseDistance(quality, limits))
        faults.push_back(VariationFault::PoseDistance);
    if (quality.skate && *quality.skate > quality.takeSkate + limits.skate * quality.size)
        faults.push_back(VariationFault::FootSkate);
    const auto beyond = static_cast<double>(quality.intersections - quality.takeIntersections);
    if (beyond > limits.intersections * static_cast<double>(quality.triangles))
        faults.push_back(VariationFault::Intersections);
    if (quality.volumeChange && std::abs(*quality.volumeChange) > limits.volumeChange)
        faults.push_back(VariationFault::Volume);
    if (quality.collapse > limits.collapse)
        faults.push_back(VariationFault::Collapse);
    if (quality.sink > limits.sink * quality.size)
        faults.push_back(VariationFault::Ground);
    return faults;
}

VariationMeter::VariationMeter(const CharacterFrames& character, std::span<const int> varied,
                               std::span<const AlignedTake> training, UpAxis up, const BodyParts& parts,
                               std::span<const double> reaches, const Progress& progress)
    : m_up(up)
    , m_frames(static_cast<std::size_t>(character.frameCount()))
    , m_training(posesOf(training, character.vertexCount()))
    , m_intersections(character.sequences().front().topology, m_training.front())
    , m_volume(*character.sequences().front().topology)
    , m_collapse(*character.sequences().front().topology, parts, m_training)
{
    m_size = boundsOf(m_training.front()).size().norm();
    std::vector<MeshSequence> sequences;
    std::vector<NodeIndex> nodes;
    std::vector<double> reachOf;
    for (std::size_t v = 0; v < varied.size(); ++v) {
        const int s = varied[v];
        sequences.push_back(character.sequences()[static_cast<std::size_t>(s)]);
        for (NodeIndex node = character.layout().firstOf(s); node <= character.layout().lastOf(s); ++node) {
            nodes.push_back(node);
            reachOf.push_back(reaches.empty() ? 0 : reaches[v]);
        }
    }
    const CharacterFrames takes(sequences);
    std::vector<Support> supports = findSupports(takes, up, progress.part(0, 0.3));
    const std::vector<FrameMeasure> measures = frameMeasures(takes, supports, up, progress.part(0.3, 0.4));
    const Progress rest = progress.part(0.4, 1);
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
        const Frame frame = character.frame(nodes[i]);
        m_frames[static_cast<std::size_t>(nodes[i])] = {
            std::move(supports[i].vertices), measures[i].slip,
            static_cast<std::int64_t>(m_intersections.find(frame.positions()).size()),
            lowestOf(frame.positions(), up), reachOf[i]};
        rest.report(++done, static_cast<std::int64_t>(nodes.size()));
    });
    for (const FrameBaseline& frame : m_frames)
        m_takeIntersections = std::max(m_takeIntersections, frame.intersections);
    m_leastVolume = std::numeric_limits<double>::infinity();
    m_greatestVolume = -m_leastVolume;
    for (const Positions& pose : m_training) {
        const double volume = m_volume.of(pose).value_or(0);
        m_leastVolume = std::min(m_leastVolume, volume);
        m_greatestVolume = std::max(m_greatestVolume, volume);
        m_meanVolume += volume / static_cast<double>(m_training.size());
    }
}

std::vector<std::uint32_t> VariationMeter::standingIn(const FrameProvenance& origin) const
{
    return common(baselineOf(origin.source).standing, baselineOf(origin.destination).standing);
}

void VariationMeter::addSkate(const Clip& clip, VariationQuality& quality) const
{
    const Ground ground(m_up);
    std::vector<std::optional<double>> speeds;
    std::array<std::vector<std::optional<double>>, 2> takeSpeeds;
    for (std::size_t f = 0; f + 1 < quality.frames.size(); ++f) {
        const auto frame = static_cast<std::int64_t>(f);
        const std::vector<std::uint32_t> standing =
            common(standingIn(clip.origins[f]), standingIn(clip.origins[f + 1]));
        if (!standing.empty())
            quality.frames[f].skate =
                clip.fps * meanSlip(clip.frame(frame), clip.frame(frame + 1), standing, ground);
        speeds.push_back(quality.frames[f].skate);
        takeSpeeds[0].push_back(baselineOf(clip.origins[f].source).slip);
        takeSpeeds[1].push_back(baselineOf(clip.origins[f].destination).slip);
    }
    quality.skate = meanOfKnown(speeds);
    quality.takeSkate =
        std::max(meanOfKnown(takeSpeeds[0]).value_or(0), meanOfKnown(takeSpeeds[1]).value_or(0));
}

void VariationMeter::addIntersections(VariationQuality& quality) const
{
    for (const VariationFrameQuality& frame : quality.frames)
        quality.intersections = std::max(quality.intersections, frame.intersections);
    quality.takeIntersections = m_takeIntersections;
}

void VariationMeter::addVolume(VariationQuality& quality) const
{
    if (!m_volume.isAvailable() || m_meanVolume == 0)
        return;
    double change = 0;
    for (const VariationFrameQuality& frame : quality.frames) {
        const double volume = frame.volume.value_or(0);
        const double beyond = volume - std::clamp(volume, m_leastVolume, m_greatestVolume);
        if (std::abs(beyond) > std::abs(change))
            change = beyond;
    }
    quality.volumeChange = change / m_meanVolume;
}

void VariationMeter::addGround(const Clip& clip, VariationQuality& quality) const
{
    double ofTake = std::numeric_limits<double>::infinity();
    double own = ofTake;
    for (std::size_t f = 0; f < quality.frames.size(); ++f) {
        const FrameProvenance& origin = clip.origins[f];
        ofTake = std::min({ofTake, baselineOf(origin.source).lowest, baselineOf(origin.destination).lowest});
        own = std::min(own, quality.frames[f].lowest);
        quality.collapse = std::max(quality.collapse, quality.frames[f].collapse);
    }
    quality.sink = quality.frames.empty() ? 0 : std::max(0.0, ofTake - own);
}

VariationQuality VariationMeter::measure(const Clip& clip, const Progress& progress) const
{
    VariationQuality quality{.frames = std::vector<VariationFrameQuality>(clip.origins.size()),
                             .size = m_size,
                             .triangles = static_cast<std::int64_t>(clip.topology->triangles().size())};
    std::vector<Positions> poses;
    for (std::int64_t f = 0; f < clip.frameCount(); ++f)
        poses.push_back(clip.frame(f));
    const std::vector<NearestPose> nearest = nearestPoses(poses, m_training, progress.part(0, 0.4));
    const Progress rest = progress.part(0.4, 1);
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(std::size_t{0}, poses.size(), [&](std::size_t f) {
        quality.frames[f] = {.nearest = nearest[f],
                             .skate = std::nullopt,
                             .intersections =
                                 static_cast<std::int64_t>(m_intersections.find(poses[f]).size()),
                             .volume = m_volume.of(poses[f]),
                             .collapse = m_collapse.of(poses[f]),
                             .lowest = lowestOf(poses[f], m_up)};
        rest.report(++done, static_cast<std::int64_t>(poses.size()));
    });
    for (const NearestPose& pose : nearest) {
        quality.meanPoseDistance += pose.distance / static_cast<double>(nearest.size());
        quality.worstPoseDistance = std::max(quality.worstPoseDistance, pose.distance);
    }
    for (const FrameProvenance& origin : clip.origins)
        quality.takeDistance = std::max(
            {quality.takeDistance, baselineOf(origin.source).reach, baselineOf(origin.destination).reach});
    addSkate(clip, quality);
    addIntersections(quality);
    addVolume(quality);
    addGround(clip, quality);
    return quality;
}

} // namespace quadrille
