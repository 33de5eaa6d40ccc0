// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/synthesis/clips/makeclip.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/synthesis/quality/liveliness.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// What shows where a transition is bad.
enum class JunctionCriterion
{
    Acceleration, ///< vertices jerk
    Frozen,       ///< a pose stands still
    CentreStep,   ///< the body leaps
    FootSlip,     ///< feet skate
    Volume,       ///< the surface shrinks or swells
};
constexpr std::size_t junctionCriteria = 5;

/// How much worse than in the takes it may be.
struct JunctionLimits
{
    double acceleration = 1.5;
    double frozen = 0.2;
    double centreStep = 1.5;
    double footSlip = 1.2;
    double volume = 0.02;
};

/// One criterion at one transition.
struct JunctionValue
{
    double value = 0;        ///< in the transition
    double limit = 0;        ///< from the takes around it
    double ratio = 0;        ///< how much of the limit is used up: good up to 1
    bool isMeasured = false; ///< whether there is something to measure; otherwise it is good
    bool isGood() const { return ratio <= 1; }
};

/// What a transition is like, by its frames and some before and behind. Segments are the windows with these
/// frames.
struct JunctionMeasures
{
    /// By JunctionCriterion:
    /// rms vertex acceleration over the frames of the transition; times the limit, the 95th percentile of
    /// that of all frames of the two takes (m/s²);
    /// vertex-mean steps: the greatest one in a row of up to three against the smaller of the steps around
    /// it, where that is least (a ratio; limit and value change places);
    /// largest step of the centre against that in the segments (m);
    /// how fast the feet slide that stand (footSlide), against the larger of the segments', or what is usual
    /// in the takes where that is more (m/s);
    /// volume, by how much it leaves the range of the windows (share of it).
    std::array<JunctionValue, junctionCriteria> values;
    double worstAcceleration = 0; ///< the largest rms of a frame, m/s²

    const JunctionValue& operator[](JunctionCriterion criterion) const
    {
        return values[static_cast<std::size_t>(criterion)];
    }
    bool isGood() const;
    double worstRatio() const;
};

/// Judges transitions of one character. Refers to what it is given. Safe from any thread.
class JunctionJudge
{
public:
    /// \param measures  of frameMeasures. \param context  frames before and behind that count.
    JunctionJudge(const CharacterFrames& character, const RootPoses& roots,
                  std::span<const FrameMeasure> measures, const JunctionLimits& limits = {}, int context = 8);

    /// \throws Error as makeClip.
    /// \param correction  of contacts, as the clip would get it; without legs there is none.
    JunctionMeasures judge(const Transition& transition, const BlendSettings& blend = {},
                           InterpolationMethod method = InterpolationMethod::Poisson,
                           const std::optional<ContactCorrectionSettings>& correction = {}) const;

private:
    struct Segments;
    Segments segmentsOf(const Transition& transition) const;
    JunctionValue acceleration(const Clip& clip, const ClipPlan::Junction& junction,
                               const Transition& transition, double& worst) const;
    JunctionValue frozen(const Clip& clip, const ClipPlan::Junction& junction) const;
    JunctionValue centreStep(const ClipPlan& plan, const Segments& segments) const;
    JunctionValue footSlip(const Clip& clip, const ClipPlan::Junction& junction,
                           std::span<const std::uint32_t> standing, const Segments& segments) const;
    /// Over the captured frames in which a foot stands, units of length a second.
    double meanSlide(NodeIndex first, NodeIndex last) const;
    JunctionValue volume(const Clip& clip, const ClipPlan::Junction& junction,
                         const Transition& transition) const;

    const CharacterFrames& m_character;
    const RootPoses& m_roots;
    std::span<const FrameMeasure> m_measures;
    Table<double> m_liveliness;
    std::vector<std::optional<double>> m_slides; ///< of capturedSlides
    double m_usualSlide = 0;                     ///< the median of all takes
    JunctionLimits m_limits;
    int m_context;
    Legs m_legs;
};

} // namespace quadrille
