// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/variedplan.h"

#include "model/core/error.h"
#include "model/core/smoothing.h"
#include "model/geometry/procrustes.h"
#include "model/synthesis/clips/rootposes.h"
#include "model/synthesis/finishing/loop.h"
#include "model/transition/poseinterpolation.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// A take some of whose frames are others.
class ReplacedFrames : public FrameSource
{
public:
    ReplacedFrames(MeshSequence take, FrameIndex first, std::vector<Vec3f> positions)
        : m_take(std::move(take)), m_first(first), m_positions(std::move(positions))
    {
    }

    std::int64_t frameCount() const override { return m_take.frameCount(); }
    std::uint32_t vertexCount() const override { return m_take.topology->vertexCount(); }
    std::optional<Positions> view(FrameIndex frame) const override
    {
        const std::int64_t replaced = frame.value - m_first.value;
        if (replaced < 0 || static_cast<std::size_t>(replaced) * vertexCount() >= m_positions.size())
            return std::nullopt;
        return Positions(m_positions)
            .subspan(static_cast<std::size_t>(replaced) * vertexCount(), vertexCount());
    }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        std::ranges::copy(m_take.frame(frame).positions(), out.begin());
    }

private:
    MeshSequence m_take;
    FrameIndex m_first;
    std::vector<Vec3f> m_positions;
};

/// The motion that lays a varied pose onto the captured one: turned to it, what stands onto what stood.
GroundMotion layingOnto(Positions varied, Positions captured, std::span<const std::uint32_t> standing,
                        const Ground& ground)
{
    const auto placeOf = [&](Positions pose) -> Vec2d {
        if (standing.empty())
            return ground.of(centroid(pose));
        Vec2d sum = Vec2d::Zero();
        for (const std::uint32_t vertex : standing)
            sum += ground.of(pose[vertex].cast<double>());
        return sum / static_cast<double>(standing.size());
    };
    return GroundMotion::taking(placeOf(varied), placeOf(captured),
                                groundAlignment(varied, captured, ground));
}

/// A take with the frames of a variation.
struct VariedTake
{
    MeshSequence sequence;
    std::vector<double> weights; ///< of each frame that is varied
    NodeIndex shift = 0;         ///< from nodes of the take to its own
};

/// Makes takes with frames of variations.
class Varier
{
public:
    Varier(const CharacterFrames& character, std::span<const Support> supports,
           const VariedPlanSettings& settings, UpAxis up)
        : m_character(character)
        , m_supports(supports)
        , m_settings(settings)
        , m_ground(up)
        , m_system(std::make_shared<const PoissonSystem>(character.sequences().front().topology))
    {
    }

    VariedTake take(const TakeVariation& variation, const Progress& progress) const
    {
        const std::size_t vertices = m_character.vertexCount();
        if (variation.positions.size() != static_cast<std::size_t>(variation.frameCount()) * vertices)
            throw Error(
                ErrorCode::VertexCountMismatch,
                {.values = {{"found", std::to_string(variation.positions.size() /
                                                     static_cast<std::size_t>(variation.frameCount()))},
                            {"expected", std::to_string(vertices)}}});
        const FrameLayout& layout = m_character.layout();
        const int index = layout.sequenceOf(variation.first);
        const MeshSequence& take = m_character.sequences()[static_cast<std::size_t>(index)];
        std::vector<Vec3f> positions = placed(variation);
        std::vector<double> weights = easedWeights(
            static_cast<std::size_t>(variation.frameCount()), variation.first > layout.firstOf(index),
            variation.last < layout.lastOf(index), m_settings.easeSeconds * take.fps);
        ease(variation, weights, positions, progress);
        const auto frames = std::make_shared<ReplacedFrames>(
            take, FrameIndex(variation.first - layout.firstOf(index)), std::move(positions));
        return {.sequence = makeSequence(take.name, take.topology, frames, take.fps),
                .weights = std::move(weights)};
    }

private:
    MutablePositions frameOf(std::vector<Vec3f>& positions, NodeIndex frame) const
    {
        return MutablePositions(positions).subspan(
            static_cast<std::size_t>(frame) * m_character.vertexCount(), m_character.vertexCount());
    }

    std::vector<Vec3f> placed(const TakeVariation& variation) const
    {
        std::vector<Vec3f> positions = variation.positions;
        const NodeIndex last = variation.frameCount() - 1;
        const auto laying = [&](NodeIndex frame) {
            const NodeIndex node = variation.first + frame;
            const Frame captured = m_character.frame(node);
            const auto standing = m_supports.empty() ? std::span<const std::uint32_t>()
                                                     : m_supports[static_cast<std::size_t>(node)].vertices;
            return layingOnto(frameOf(positions, frame), captured.positions(), standing, m_ground);
        };
        const GroundMotion first = laying(0);
        const GroundMotion change = laying(last) * first.inverse();
        std::vector<Vec2d> deviations; // of the centre, from that of the captured frame
        for (NodeIndex f = 0; f <= last; ++f) {
            const double share = last == 0 ? 0 : static_cast<double>(f) / last;
            moveFrame(frameOf(positions, f), partOf(change, share) * first, m_ground);
            const Frame captured = m_character.frame(variation.first + f);
            deviations.push_back(
                m_ground.of(centroid(frameOf(positions, f)) - centroid(captured.positions())));
        }
        const MeshSequence& take = m_character.sequences().front();
        const std::vector<Vec2d> even = evened(deviations, m_settings.wayEvening * take.fps);
        for (NodeIndex f = 0; f <= last; ++f) {
            const auto at = static_cast<std::size_t>(f);
            moveFrame(frameOf(positions, f), {0, even[at] - deviations[at]}, m_ground);
        }
        return positions;
    }

    void ease(const TakeVariation& variation, const std::vector<double>& weights,
              std::vector<Vec3f>& positions, const Progress& progress) const
    {
        std::vector<Frame> captured;
        std::vector<Positions> sources;
        std::vector<Positions> targets;
        std::vector<BlendStep> steps;
        std::vector<NodeIndex> eased;
        for (NodeIndex f = 0; f < variation.frameCount(); ++f) {
            const double weight = weights[static_cast<std::size_t>(f)];
            if (weight == 1)
                continue;
            const int step = static_cast<int>(steps.size());
            captured.push_back(m_character.frame(variation.first + f));
            sources.push_back(captured.back().positions());
            targets.push_back(frameOf(positions, f));
            steps.push_back(
                {.source = step, .target = step, .lambda = weight, .placeSource = {}, .placeTarget = {}});
            eased.push_back(f);
        }
        const std::vector<Vec3f> blended =
            blendPoses(m_system, sources, targets, steps, m_settings.interpolation, progress);
        for (std::size_t i = 0; i < eased.size(); ++i)
            std::ranges::copy(
                Positions(blended).subspan(i * m_character.vertexCount(), m_character.vertexCount()),
                frameOf(positions, eased[i]).begin());
    }

    const CharacterFrames& m_character;
    std::span<const Support> m_supports;
    VariedPlanSettings m_settings;
    Ground m_ground;
    std::shared_ptr<const PoissonSystem> m_system;
};

/// What one side of a planned frame shows.
struct Side
{
    const TakeVariation* variation = nullptr; ///< null: as captured
    const VariedTake* take = nullptr;
    std::int32_t number = 0;

    double weightOf(NodeIndex node) const
    {
        return variation && variation->varies(node)
                   ? take->weights[static_cast<std::size_t>(node - variation->first)]
                   : 0;
    }
    FrameTime shown(FrameTime time) const
    {
        if (take)
            time.frame += take->shift;
        return time;
    }
};

Vec3d centreAt(const CharacterFrames& character, const FrameTime& time)
{
    const Vec3d here = centroid(character.frame(time.frame).positions());
    return time.part == 0 ? here
                          : Vec3d((1 - time.part) * here +
                                  time.part * centroid(character.frame(time.next()).positions()));
}

/// Shows what both sides show. \param isBetween  two spans: the sides are two.
void vary(PlannedFrame& planned, const Side& source, const Side& destination, bool isBetween)
{
    FrameProvenance& origin = planned.origin;
    const double weight = source.weightOf(origin.source);
    if (isBetween) {
        origin.sourceVariation = weight < 0.5 ? 0 : source.number;
        origin.destinationVariation = destination.weightOf(origin.destination) < 0.5 ? 0 : destination.number;
    } else if (weight > 0) {
        origin.sourceVariation = weight < 1 ? 0 : source.number;
        origin.destinationVariation = source.number;
        origin.lambda = weight < 1 ? weight : 0;
    }
    planned.times.source = source.shown(planned.times.source);
    planned.times.destination = destination.shown(planned.times.destination);
}

} // namespace

std::vector<double> easedWeights(std::size_t count, bool easesIn, bool easesOut, double frames)
{
    const auto ease = static_cast<std::size_t>(
        std::clamp(std::round(frames), 0.0, std::floor(static_cast<double>(count) / 3)));
    std::vector<double> weights(count, 1);
    for (std::size_t f = 0; f < ease; ++f) {
        const double even = static_cast<double>(f + 1) / static_cast<double>(ease + 1);
        const double smooth = even * even * (3 - 2 * even);
        if (easesIn)
            weights[f] = smooth;
        if (easesOut)
            weights[count - 1 - f] = smooth;
    }
    return weights;
}

VariedPlan variedPlan(const CharacterFrames& character, ClipPlan plan, std::span<const SpanDraw> spans,
                      std::span<const TakeVariation> variations, std::span<const Support> supports,
                      const VariedPlanSettings& settings, const Progress& progress)
{
    progress.report(0.0);
    if (std::ranges::none_of(spans, [](const SpanDraw& span) { return span.variation.has_value(); }))
        return {.character = character, .plan = std::move(plan)};
    const Varier varier(character, supports, settings, plan.up);
    std::vector<MeshSequence> sequences(character.sequences().begin(), character.sequences().end());
    std::vector<std::optional<VariedTake>> takes(variations.size());
    NodeIndex frames = character.frameCount();
    for (std::size_t s = 0; s < spans.size(); ++s) {
        if (!spans[s].variation || takes[*spans[s].variation])
            continue;
        const auto share = [&](std::size_t span) {
            return static_cast<double>(span) / static_cast<double>(spans.size());
        };
        const TakeVariation& variation = variations[*spans[s].variation];
        VariedTake& take =
            takes[*spans[s].variation].emplace(varier.take(variation, progress.part(share(s), share(s + 1))));
        const FrameLayout& layout = character.layout();
        take.shift = frames - layout.firstOf(layout.sequenceOf(variation.first));
        frames += static_cast<NodeIndex>(take.sequence.frameCount());
        sequences.push_back(take.sequence);
    }
    VariedPlan varied{.character = CharacterFrames(sequences), .plan = std::move(plan)};
    const auto sideOf = [&](std::size_t span) {
        const auto variation = spans[span].variation;
        return variation ? Side{&variations[*variation], &*takes[*variation],
                                static_cast<std::int32_t>(*variation) + 1}
                         : Side();
    };
    const Ground ground(varied.plan.up);
    for (std::int64_t f = 0; f < varied.plan.frameCount(); ++f) {
        const bool isBetween = isBetweenSpans(varied.plan, f);
        const std::size_t span = spanAt(varied.plan, f);
        const Side source = sideOf(span);
        const Side destination = isBetween ? sideOf(span + 1) : source;
        if (!source.take && !destination.take)
            continue;
        PlannedFrame& planned = varied.plan.frames[static_cast<std::size_t>(f)];
        vary(planned, source, destination, isBetween);
        planned.centre = (1 - planned.lambda) *
                             planned.placeSource(centreAt(varied.character, planned.times.source), ground) +
                         planned.lambda * planned.placeDestination(
                                              centreAt(varied.character, planned.times.destination), ground);
    }
    progress.report(1.0);
    return varied;
}

} // namespace quadrille
