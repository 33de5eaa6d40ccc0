// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/selfintersections.h"
#include "model/geometry/surfacevolume.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/supports.h"
#include "model/transition/nearestposes.h"
#include "model/variation/parts/surfacecollapse.h"
#include "model/variation/training.h"
#include "model/variation/variationlimits.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace quadrille {

/// What a frame of a variation is like.
struct VariationFrameQuality
{
    NearestPose nearest; ///< of all poses learned from, one take after the other
    /// Mean horizontal speed, until the next frame, of the vertices that stand in the take, m/s; nothing
    /// where none do.
    std::optional<double> skate;
    std::int64_t intersections = 0; ///< pairs of triangles that go through each other
    std::optional<double> volume;   ///< signed, m³; nothing where the surface has no inside
    double collapse = 0;            ///< SurfaceCollapse::of
    double lowest = 0;              ///< height of the lowest vertex, metres
};

/// What a variation is like, against the takes that it varies and all poses learned from.
struct VariationQuality
{
    std::vector<VariationFrameQuality> frames;
    double size = 0;                    ///< of the figure: diagonal of its box, metres
    std::int64_t triangles = 0;         ///< of the surface
    double meanPoseDistance = 0;        ///< from the nearest poses learned from, metres
    double worstPoseDistance = 0;       ///< metres
    double takeDistance = 0;            ///< what poseReaches says of the takes, of two the larger one, metres
    std::optional<double> skate;        ///< mean over the frames in which something stands, m/s
    double takeSkate = 0;               ///< the same of the take, of two takes the larger one, m/s
    std::int64_t intersections = 0;     ///< most of a frame
    std::int64_t takeIntersections = 0; ///< most of a frame of the takes
    /// How far the volume leaves the range of the poses learned from, as a share of their mean: negative
    /// where it falls below; 0 inside.
    std::optional<double> volumeChange;
    double collapse = 0; ///< of the worst frame
    /// How much deeper its deepest point is than that of the captured frames that it follows, metres.
    double sink = 0;
};

/// Why a variation is bad.
enum class VariationFault
{
    PoseDistance,  ///< a pose like none that was learned from
    FootSkate,     ///< feet slide
    Intersections, ///< the surface goes through itself
    Volume,        ///< the body swells or shrinks
    Collapse,      ///< a region of the surface shrinks or folds up
    Ground,        ///< it sinks into the ground
};
constexpr std::size_t variationFaults = 6;

/// "pose-distance", "foot-skate", "intersections", "volume", "collapse" or "ground".
std::string_view toString(VariationFault fault);

/// The distance of a variation's worst frame from the nearest pose learned from that is still good, metres.
double greatestPoseDistance(const VariationQuality& quality, const VariationLimits& limits = {});

/// All that is wrong with a variation; nothing where it is good. What could not be measured is good.
std::vector<VariationFault> judge(const VariationQuality& quality, const VariationLimits& limits = {});

/// Measures variations of some takes of a character. What all have in common is prepared once. Refers to
/// what it is given. Immutable; safe from any thread.
class VariationMeter
{
public:
    /// \param character  whose frames the origins of variations count.
    /// \param varied  its sequences that variations are made of, each once.
    /// \param training  what was learned from, with at least one pose.
    /// \param parts  of the body, whose regions may not collapse. \param reaches  of each varied sequence,
    /// poseReaches; none where nothing is known.
    /// \throws Error what reading frames throws, Cancelled.
    VariationMeter(const CharacterFrames& character, std::span<const int> varied,
                   std::span<const AlignedTake> training, UpAxis up, const BodyParts& parts = {},
                   std::span<const double> reaches = {}, const Progress& progress = {});

    /// \pre The origins of the clip are frames of the varied sequences.
    /// \throws Error Cancelled.
    VariationQuality measure(const Clip& clip, const Progress& progress = {}) const;

private:
    struct FrameBaseline
    {
        std::vector<std::uint32_t> standing; ///< vertices
        std::optional<double> slip;          ///< m/s
        std::int64_t intersections = 0;
        double lowest = 0; ///< metres
        double reach = 0;  ///< of its take, metres
    };
    const FrameBaseline& baselineOf(NodeIndex node) const { return m_frames[static_cast<std::size_t>(node)]; }
    std::vector<std::uint32_t> standingIn(const FrameProvenance& origin) const;
    void addSkate(const Clip& clip, VariationQuality& quality) const;
    void addIntersections(VariationQuality& quality) const;
    void addVolume(VariationQuality& quality) const;
    void addGround(const Clip& clip, VariationQuality& quality) const;

    UpAxis m_up;
    double m_size;
    std::vector<FrameBaseline> m_frames; ///< by node; those of other sequences are empty
    std::vector<Positions> m_training;
    SelfIntersections m_intersections;
    SurfaceVolume m_volume;
    SurfaceCollapse m_collapse;
    std::int64_t m_takeIntersections = 0;
    double m_leastVolume = 0;
    double m_greatestVolume = 0;
    double m_meanVolume = 0;
};

} // namespace quadrille
