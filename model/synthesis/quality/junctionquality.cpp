// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/junctionquality.h"

#include "model/core/ranks.h"
#include "model/synthesis/clips/characterlegs.h"
#include "model/synthesis/quality/junctionspeeds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace quadrille {

namespace {

/// Nothing is measured where there is nothing to compare with.
JunctionValue against(double value, double limit)
{
    if (!(limit > 0))
        return {};
    return {.value = value, .limit = limit, .ratio = value / limit, .isMeasured = true};
}

} // namespace

bool JunctionMeasures::isGood() const
{
    return std::ranges::all_of(values, &JunctionValue::isGood);
}

double JunctionMeasures::worstRatio() const
{
    return std::ranges::max_element(values, {}, &JunctionValue::ratio)->ratio;
}

/// Frames of the two takes with which a transition is compared, and the walk that shows them.
struct JunctionJudge::Segments
{
    Walk walk;
    std::array<WalkSpan, 2> spans;

    /// Calls with each frame but the last of both segments.
    void forEachStep(const auto& call) const
    {
        for (const WalkSpan& span : spans) {
            for (NodeIndex node = span.first; node < span.last; ++node)
                call(node);
        }
    }
};

JunctionJudge::JunctionJudge(const CharacterFrames& character, const RootPoses& roots,
                             std::span<const FrameMeasure> measures, const JunctionLimits& limits,
                             int context)
    : m_character(character)
    , m_roots(roots)
    , m_measures(measures)
    , m_liveliness(livelinessOf(measures, character.layout()))
    , m_slides(capturedSlides(character, roots.stances, roots.up))
    , m_limits(limits)
    , m_context(context)
    , m_legs(legsOf(character, roots.up))
{
    std::vector<double> slides;
    slides.reserve(static_cast<std::size_t>(character.layout().sequenceCount()));
    for (int sequence = 0; sequence < character.layout().sequenceCount(); ++sequence)
        slides.push_back(
            meanSlide(character.layout().firstOf(sequence), character.layout().lastOf(sequence)));
    m_usualSlide = slides.empty() ? 0 : quantile(std::move(slides), 0.5);
}

JunctionJudge::Segments JunctionJudge::segmentsOf(const Transition& transition) const
{
    const FrameLayout& layout = m_character.layout();
    const auto [source, destination] = transition.frames;
    const NodeIndex before = std::max(source - m_context, layout.firstOf(layout.sequenceOf(source)));
    const NodeIndex behind = std::min(destination + m_context, layout.lastOf(layout.sequenceOf(destination)));
    return {.walk = {{{before, source}, {destination, behind}}},
            .spans = {WalkSpan{before, source + transition.sourceWindow - 1},
                      WalkSpan{destination - transition.destinationWindow + 1, behind}}};
}

JunctionMeasures JunctionJudge::judge(const Transition& transition, const BlendSettings& blend,
                                      InterpolationMethod method,
                                      const std::optional<ContactCorrectionSettings>& correction) const
{
    const Segments segments = segmentsOf(transition);
    const ClipPlan plan =
        planClip(m_roots, segments.walk, std::span(&transition, 1), {.start = {}, .blend = blend});
    Clip clip = makeClip(m_character, plan, method);
    const std::vector<std::uint32_t> standing = stancesOf(clip, m_roots.stances);
    if (correction && !m_legs.feet.empty()) {
        const std::vector<ContactSpan> contacts = contactsOf(standing, m_roots.stances);
        clip = contactsCorrected(std::move(clip), contacts, *correction,
                                 {.up = m_roots.up, .frames = {}, .legs = &m_legs, .trustsLegs = true});
    }
    const ClipPlan::Junction& junction = plan.junctions.front();
    JunctionMeasures measures;
    measures.values = {acceleration(clip, junction, transition, measures.worstAcceleration),
                       frozen(clip, junction), centreStep(plan, segments),
                       footSlip(clip, junction, standing, segments), volume(clip, junction, transition)};
    return measures;
}

JunctionValue JunctionJudge::acceleration(const Clip& clip, const ClipPlan::Junction& junction,
                                          const Transition& transition, double& worst) const
{
    const FrameLayout& layout = m_character.layout();
    double sum = 0;
    int count = 0;
    for (std::int64_t f = std::max<std::int64_t>(junction.first, 1);
         f <= std::min(junction.last, clip.frameCount() - 2); ++f) {
        const double value = rmsAcceleration(clip.frame(f - 1), clip.frame(f), clip.frame(f + 1), clip.fps);
        worst = std::max(worst, value);
        sum += value * value;
        ++count;
    }
    if (count == 0)
        return {};
    const double lively = m_liveliness(layout.sequenceOf(transition.frames.source),
                                       layout.sequenceOf(transition.frames.destination));
    return against(std::sqrt(sum / count), m_limits.acceleration * lively);
}

JunctionValue JunctionJudge::frozen(const Clip& clip, const ClipPlan::Junction& junction) const
{
    constexpr std::int64_t longestRow = 3;
    std::vector<double> steps;
    for (std::int64_t f = 0; f + 1 < clip.frameCount(); ++f)
        steps.push_back(meanStep(clip.frame(f), clip.frame(f + 1)));
    double least = std::numeric_limits<double>::infinity();
    const auto count = static_cast<std::int64_t>(steps.size());
    for (std::int64_t first = std::max<std::int64_t>(junction.first, 1); first < junction.last; ++first) {
        double greatest = 0;
        for (std::int64_t last = first; last < std::min(first + longestRow, count - 1); ++last) {
            greatest = std::max(greatest, steps[static_cast<std::size_t>(last)]);
            const double around = std::min(steps[static_cast<std::size_t>(first) - 1],
                                           steps[static_cast<std::size_t>(last) + 1]);
            if (around > 0)
                least = std::min(least, greatest / around);
        }
    }
    if (std::isinf(least))
        return {};
    constexpr double nearlyNothing = 1e-6;
    return {.value = least,
            .limit = m_limits.frozen,
            .ratio = m_limits.frozen / std::max(least, nearlyNothing),
            .isMeasured = true};
}

JunctionValue JunctionJudge::centreStep(const ClipPlan& plan, const Segments& segments) const
{
    const ClipPlan::Junction& junction = plan.junctions.front();
    double largest = 0;
    for (auto f = static_cast<std::size_t>(junction.first); f < static_cast<std::size_t>(junction.last); ++f)
        largest = std::max(largest, (plan.frames[f + 1].centre - plan.frames[f].centre).norm());
    double captured = 0;
    segments.forEachStep([&](NodeIndex node) {
        const auto n = static_cast<std::size_t>(node);
        captured = std::max(captured, (m_roots.centres[n + 1] - m_roots.centres[n]).norm());
    });
    return against(largest, m_limits.centreStep * captured);
}

JunctionValue JunctionJudge::footSlip(const Clip& clip, const ClipPlan::Junction& junction,
                                      std::span<const std::uint32_t> standing, const Segments& segments) const
{
    const auto slide = footSlide(clip, junction, m_roots, standing);
    double captured = m_usualSlide;
    for (const WalkSpan& span : segments.spans)
        captured = std::max(captured, meanSlide(span.first, span.last));
    return slide ? against(*slide, m_limits.footSlip * captured) : JunctionValue{};
}

double JunctionJudge::meanSlide(NodeIndex first, NodeIndex last) const
{
    double sum = 0;
    int count = 0;
    for (NodeIndex node = first; node < last; ++node) {
        if (const auto& slide = m_slides[static_cast<std::size_t>(node)]) {
            sum += *slide;
            ++count;
        }
    }
    return sum / std::max(count, 1);
}

JunctionValue JunctionJudge::volume(const Clip& clip, const ClipPlan::Junction& junction,
                                    const Transition& transition) const
{
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    const auto include = [&](NodeIndex first, int count) {
        for (NodeIndex node = first; node < first + count; ++node) {
            const double volume = m_measures[static_cast<std::size_t>(node)].volume;
            least = std::min(least, volume);
            greatest = std::max(greatest, volume);
        }
    };
    include(transition.frames.source, transition.sourceWindow);
    include(transition.frames.destination - transition.destinationWindow + 1, transition.destinationWindow);
    double beyond = 0;
    for (std::int64_t f = junction.first; f <= junction.last; ++f) {
        const double volume = enclosedVolume(clip.frame(f), m_character.triangles());
        beyond = std::max({beyond, (least - volume) / least, (volume - greatest) / greatest});
    }
    return against(beyond, m_limits.volume);
}

} // namespace quadrille
