// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/finishing/footdrift.h"

#include "model/synthesis/finishing/turnkernel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <span>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <vector>

namespace quadrille {

namespace {

/// Frames before and behind a transition in which a foot that stands there keeps it in its place.
constexpr int driftContext = 8;

Vec2d turned(const TurnParts& turn, const Vec2d& way)
{
    return {turn.cosine * way.x() - turn.sine * way.y(), turn.sine * way.x() + turn.cosine * way.y()};
}

/// Of the difference of two angles of at most a half turn each: at most a half turn.
double nearestTurn(double angle)
{
    constexpr double half = std::numbers::pi;
    return angle > half ? angle - 2 * half : angle <= -half ? angle + 2 * half : angle;
}

} // namespace

/// What is known of each frame, whatever it is blended with; everything on the ground.
class FeetOfFrames
{
public:
    FeetOfFrames(const RootPoses& roots, const FrameLayout& layout) : m_count(roots.stances.feet.size())
    {
        const Ground ground(roots.up);
        const Stances& stances = roots.stances;
        for (NodeIndex node = 0; node < layout.frameCount(); ++node) {
            m_centres.push_back(ground.of(roots.centres[static_cast<std::size_t>(node)]));
            for (std::size_t foot = 0; foot < m_count; ++foot) {
                m_reaches.push_back(ground.of(stances.placeOf(node, foot)) - m_centres.back());
                m_before.push_back(standsBefore(stances, layout, node, foot));
                m_behind.push_back(standsBehind(stances, layout, node, foot));
            }
        }
    }

    std::size_t count() const { return m_count; }
    const Vec2d& centre(NodeIndex node) const { return m_centres[static_cast<std::size_t>(node)]; }
    /// From the centre to a foot.
    const Vec2d& reach(NodeIndex node, std::size_t foot) const { return m_reaches[at(node, foot)]; }
    /// How many frames, up to some, a foot stands on end before a frame, or behind it.
    int before(NodeIndex node, std::size_t foot) const { return m_before[at(node, foot)]; }
    int behind(NodeIndex node, std::size_t foot) const { return m_behind[at(node, foot)]; }

private:
    std::size_t at(NodeIndex node, std::size_t foot) const
    {
        return static_cast<std::size_t>(node) * m_count + foot;
    }

    static int standsBefore(const Stances& stances, const FrameLayout& layout, NodeIndex node,
                            std::size_t foot)
    {
        const NodeIndex first = std::max(layout.firstOf(layout.sequenceOf(node)), node - driftContext);
        int count = 0;
        for (NodeIndex n = node - 1; n >= first && stances.stands(n, foot); --n)
            ++count;
        return count;
    }

    static int standsBehind(const Stances& stances, const FrameLayout& layout, NodeIndex node,
                            std::size_t foot)
    {
        const NodeIndex last = std::min(layout.lastOf(layout.sequenceOf(node)), node + driftContext);
        int count = 0;
        for (NodeIndex n = node + 1; n <= last && stances.stands(n, foot); ++n)
            ++count;
        return count;
    }

    std::size_t m_count; ///< feet
    std::vector<Vec2d> m_centres;
    std::vector<Vec2d> m_reaches;
    std::vector<int> m_before;
    std::vector<int> m_behind;
};

namespace {

/// How a transition of some length advances; the same for all of them.
class Advances
{
public:
    /// By the frames of the transition: how much the destination counts.
    const std::vector<double>& lambdas(int length)
    {
        auto& known = entry(m_lambdas, length);
        for (int t = std::ssize(known); t < length; ++t) {
            const double even = evenly(t, length);
            known.push_back(even * even * (3 - 2 * even));
        }
        return known;
    }

    /// By the frames of the transition: the frame of a window.
    const std::vector<NodeIndex>& frames(int length, int window)
    {
        auto& known = entry(entry(m_frames, length), window);
        for (int t = std::ssize(known); t < length; ++t)
            known.push_back(static_cast<NodeIndex>(std::lround(evenly(t, length) * (window - 1))));
        return known;
    }

private:
    static double evenly(int t, int length) { return length > 1 ? static_cast<double>(t) / (length - 1) : 0; }

    template <typename Entry>
    static Entry& entry(std::vector<Entry>& entries, int index)
    {
        if (std::ssize(entries) <= index)
            entries.resize(static_cast<std::size_t>(index) + 1);
        return entries[static_cast<std::size_t>(index)];
    }

    std::vector<std::vector<double>> m_lambdas;
    std::vector<std::vector<std::vector<NodeIndex>>> m_frames;
};

/// Follows the feet through one transition after the other. For one thread.
class FootFollower
{
public:
    FootFollower(const RootPoses& roots, const FeetOfFrames& feet, double fps)
        : m_roots(roots)
        , m_stances(roots.stances)
        , m_feet(feet)
        , m_longestGap(static_cast<std::size_t>(longestStanceGap * fps))
    {
    }

    /// Units of length. \pre The windows are those of a transition.
    double drift(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow);

private:
    /// A frame of the transition.
    struct Step
    {
        NodeIndex source = 0;
        NodeIndex destination = 0;
        double lambda = 0;
        std::uint32_t standing = 0; ///< in the clip
        Vec2d centre = Vec2d::Zero();
    };

    /// From the centre of the blended pose to a foot.
    Vec2d reach(std::size_t t, std::size_t foot) const
    {
        const Step& step = m_steps[t];
        return (1 - step.lambda) * turned(sourceTurn(t), m_feet.reach(step.source, foot)) +
               step.lambda * turned(destinationTurn(t), m_feet.reach(step.destination, foot));
    }
    const TurnParts& sourceTurn(std::size_t t) const { return m_turns[t]; }
    const TurnParts& destinationTurn(std::size_t t) const { return m_turns[m_steps.size() + t]; }
    void setSteps(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow);
    void setTurns();
    Vec2d wayOfCentre(std::size_t t) const;
    void closeGaps(std::uint32_t bit);
    double driftOf(std::size_t foot) const;

    const RootPoses& m_roots;
    const Stances& m_stances;
    const FeetOfFrames& m_feet;
    std::size_t m_longestGap;
    Advances m_advances;
    std::vector<Step> m_steps;
    // Of the source by step, then of the destination.
    std::vector<double> m_angles;
    std::vector<TurnParts> m_turns;
    std::vector<Vec2d> m_places; ///< of one foot, by step
};

void FootFollower::setSteps(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow)
{
    m_steps.resize(static_cast<std::size_t>(length));
    const std::vector<double>& lambdas = m_advances.lambdas(length);
    // The second may move the first where it is new.
    m_advances.frames(length, std::max(sourceWindow, destinationWindow));
    const std::vector<NodeIndex>& sources = m_advances.frames(length, sourceWindow);
    const std::vector<NodeIndex>& destinations = m_advances.frames(length, destinationWindow);
    for (std::size_t t = 0; t < m_steps.size(); ++t) {
        Step& step = m_steps[t];
        step.source = i + sources[t];
        step.destination = j - destinationWindow + 1 + destinations[t];
        step.lambda = lambdas[t];
        step.standing = m_stances.at(step.lambda < 0.5 ? step.source : step.destination);
    }
}

void FootFollower::setTurns()
{
    const std::size_t count = m_steps.size();
    m_angles.resize(2 * count);
    m_turns.resize(2 * count);
    double source = 0;
    double betweenBefore = 0;
    for (std::size_t t = 0; t < count; ++t) {
        const Step& step = m_steps[t];
        const auto between = static_cast<double>(m_roots.turns(step.source, step.destination));
        if (t > 0)
            source -= step.lambda * nearestTurn(between - betweenBefore);
        betweenBefore = between;
        m_angles[t] = source;
        m_angles[count + t] = source + between;
    }
    turnsOf(m_angles, m_turns);
}

/// Since the step before, as transitionMotion has it.
Vec2d FootFollower::wayOfCentre(std::size_t t) const
{
    const Step& before = m_steps[t - 1];
    const Step& now = m_steps[t];
    return (1 - before.lambda) *
               turned(sourceTurn(t - 1), m_feet.centre(now.source) - m_feet.centre(before.source)) +
           before.lambda * turned(destinationTurn(t - 1),
                                  m_feet.centre(now.destination) - m_feet.centre(before.destination));
}

void FootFollower::closeGaps(std::uint32_t bit)
{
    for (std::size_t t = 1; t < m_steps.size(); ++t) {
        if ((m_steps[t].standing & bit) != 0 || (m_steps[t - 1].standing & bit) == 0)
            continue;
        std::size_t end = t;
        while (end < m_steps.size() && (m_steps[end].standing & bit) == 0)
            ++end;
        if (end == m_steps.size() || end - t > m_longestGap ||
            (m_places[end] - m_places[t - 1]).norm() > longestCarry * m_stances.height)
            continue;
        for (std::size_t g = t; g < end; ++g)
            m_steps[g].standing |= bit;
    }
}

double FootFollower::driftOf(std::size_t foot) const
{
    const auto stands = [&](std::size_t t) { return (m_steps[t].standing >> foot & 1U) != 0; };
    double greatest = 0; // squared
    for (std::size_t first = 0; first < m_steps.size(); ++first) {
        if (!stands(first))
            continue;
        std::size_t last = first;
        while (last + 1 < m_steps.size() && stands(last + 1))
            ++last;
        const auto weightAt = [&](std::size_t t) {
            return 1 + (t == 0 ? m_feet.before(m_steps.front().source, foot) : 0) +
                   (t + 1 == m_steps.size() ? m_feet.behind(m_steps.back().destination, foot) : 0);
        };
        Vec2d mean = Vec2d::Zero();
        int sum = 0;
        for (std::size_t t = first; t <= last; ++t) {
            const int weight = weightAt(t);
            mean += weight * m_places[t];
            sum += weight;
        }
        mean /= sum;
        for (std::size_t t = first; t <= last; ++t)
            greatest = std::max(greatest, (m_places[t] - mean).squaredNorm());
        first = last;
    }
    return std::sqrt(greatest);
}

double FootFollower::drift(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow)
{
    setSteps(i, j, length, sourceWindow, destinationWindow);
    std::uint32_t standing = 0;
    for (const Step& step : m_steps)
        standing |= step.standing;
    if (standing == 0)
        return 0;
    setTurns();
    m_steps.front().centre.setZero();
    for (std::size_t t = 1; t < m_steps.size(); ++t)
        m_steps[t].centre = m_steps[t - 1].centre + wayOfCentre(t);
    double greatest = 0;
    for (std::size_t foot = 0; foot < m_feet.count(); ++foot) {
        if ((standing >> foot & 1U) == 0)
            continue;
        m_places.clear();
        for (std::size_t t = 0; t < m_steps.size(); ++t)
            m_places.push_back(m_steps[t].centre + reach(t, foot));
        closeGaps(1U << foot);
        greatest = std::max(greatest, driftOf(foot));
    }
    return greatest;
}

bool areFeetKnown(const RootPoses& roots)
{
    return roots.stances.isKnown() && roots.stances.height > 0;
}

} // namespace

FootDrifts::FootDrifts(const RootPoses& roots, const FrameLayout& layout, double fps)
    : m_roots(roots)
    , m_fps(fps)
    , m_feet(areFeetKnown(roots) ? std::make_shared<const FeetOfFrames>(roots, layout) : nullptr)
{
}

float FootDrifts::of(const KnownTransition& transition, const FramePair& pair) const
{
    if (!m_feet || transition.length == 0)
        return 0;
    const double drift = FootFollower(m_roots, *m_feet, m_fps)
                             .drift(pair.source, pair.destination, transition.length, transition.sourceWindow,
                                    transition.destinationWindow);
    return static_cast<float>(drift / m_roots.stances.height);
}

Table<float> footDrifts(const RootPoses& roots, const FrameLayout& layout, const TransitionTable& transitions,
                        double fps, const Progress& progress)
{
    const NodeIndex frames = layout.frameCount();
    Table<float> drifts = Table<float>::Zero(frames, frames);
    const double height = roots.stances.height;
    if (!areFeetKnown(roots))
        return drifts;
    const FeetOfFrames feet(roots, layout);
    tbb::enumerable_thread_specific<FootFollower> followers([&] { return FootFollower(roots, feet, fps); });
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        FootFollower& follower = followers.local();
        for (NodeIndex j = 0; j < frames; ++j) {
            if (const int length = transitions.length(i, j); length > 0)
                drifts(i, j) = static_cast<float>(follower.drift(i, j, length, transitions.sourceWindow(i, j),
                                                                 transitions.destinationWindow(i, j)) /
                                                  height);
        }
        progress.report(++done, std::int64_t{frames});
    });
    return drifts;
}

} // namespace quadrille
