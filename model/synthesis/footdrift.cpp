// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/footdrift.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Frames before and behind a transition in which a foot that stands there keeps it in its place.
constexpr int driftContext = 8;

/// Follows the feet through one transition after the other. For one thread.
class FootFollower
{
public:
    FootFollower(const RootPoses& roots, const FrameLayout& layout, double fps)
        : m_roots(roots)
        , m_stances(roots.stances)
        , m_layout(layout)
        , m_ground(roots.up)
        , m_longestGap(static_cast<std::size_t>(longestStanceGap * fps))
        , m_feet(roots.stances.feet.size())
    {
    }

    /// Units of length. \pre The windows are those of a transition.
    double drift(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow);

private:
    /// A frame of the transition; everything on the ground.
    struct Step
    {
        NodeIndex source = 0;
        NodeIndex destination = 0;
        double lambda = 0;
        std::uint32_t standing = 0; ///< in the clip
        Eigen::Rotation2Dd sourceTurn{0};
        Eigen::Rotation2Dd destinationTurn{0};
    };

    Vec2d centreOf(NodeIndex node) const
    {
        return m_ground.of(m_roots.centres[static_cast<std::size_t>(node)]);
    }
    Vec2d footOf(NodeIndex node, std::size_t foot) const
    {
        return m_ground.of(m_stances.placeOf(node, foot));
    }
    /// From the centre of the blended pose to a foot.
    Vec2d reach(const Step& step, std::size_t foot) const
    {
        return (1 - step.lambda) *
                   (step.sourceTurn * Vec2d(footOf(step.source, foot) - centreOf(step.source))) +
               step.lambda * (step.destinationTurn *
                              Vec2d(footOf(step.destination, foot) - centreOf(step.destination)));
    }
    Vec2d placeAt(std::size_t t, std::size_t foot) const { return m_centres[t] + reach(m_steps[t], foot); }
    void setSteps(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow);
    void turn(Step& step, const Step& before) const;
    Vec2d wayOfCentre(const Step& before, const Step& now) const;
    /// How many frames, up to some, a foot stands on end before one frame, or behind it.
    int standsBefore(NodeIndex node, std::size_t foot) const;
    int standsBehind(NodeIndex node, std::size_t foot) const;
    void closeGaps(std::size_t foot);
    double driftOf(std::size_t foot) const;

    const RootPoses& m_roots;
    const Stances& m_stances;
    const FrameLayout& m_layout;
    Ground m_ground;
    std::size_t m_longestGap;
    std::size_t m_feet;
    std::vector<Step> m_steps;
    std::vector<Vec2d> m_centres;
};

void FootFollower::setSteps(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow)
{
    m_steps.assign(static_cast<std::size_t>(length), {});
    for (int t = 0; t < length; ++t) {
        const double even = length > 1 ? static_cast<double>(t) / (length - 1) : 0;
        const auto along = [even](int window) {
            return static_cast<NodeIndex>(std::lround(even * (window - 1)));
        };
        Step& step = m_steps[static_cast<std::size_t>(t)];
        step.source = i + along(sourceWindow);
        step.destination = j - destinationWindow + 1 + along(destinationWindow);
        step.lambda = even * even * (3 - 2 * even);
        step.standing = m_stances.at(step.lambda < 0.5 ? step.source : step.destination);
    }
}

void FootFollower::turn(Step& step, const Step& before) const
{
    const auto between = static_cast<double>(m_roots.turns(step.source, step.destination));
    const double source = before.sourceTurn.angle();
    step.sourceTurn.angle() =
        source - step.lambda * wrappedAngle(source + between - before.destinationTurn.angle());
    step.destinationTurn.angle() = step.sourceTurn.angle() + between;
}

/// As transitionMotion has it.
Vec2d FootFollower::wayOfCentre(const Step& before, const Step& now) const
{
    return (1 - before.lambda) * (before.sourceTurn * Vec2d(centreOf(now.source) - centreOf(before.source))) +
           before.lambda *
               (before.destinationTurn * Vec2d(centreOf(now.destination) - centreOf(before.destination)));
}

int FootFollower::standsBefore(NodeIndex node, std::size_t foot) const
{
    const NodeIndex first = std::max(m_layout.firstOf(m_layout.sequenceOf(node)), node - driftContext);
    int count = 0;
    for (NodeIndex n = node - 1; n >= first && m_stances.stands(n, foot); --n)
        ++count;
    return count;
}

int FootFollower::standsBehind(NodeIndex node, std::size_t foot) const
{
    const NodeIndex last = std::min(m_layout.lastOf(m_layout.sequenceOf(node)), node + driftContext);
    int count = 0;
    for (NodeIndex n = node + 1; n <= last && m_stances.stands(n, foot); ++n)
        ++count;
    return count;
}

void FootFollower::closeGaps(std::size_t foot)
{
    const std::uint32_t bit = 1U << foot;
    for (std::size_t t = 1; t < m_steps.size(); ++t) {
        if ((m_steps[t].standing & bit) != 0 || (m_steps[t - 1].standing & bit) == 0)
            continue;
        std::size_t end = t;
        while (end < m_steps.size() && (m_steps[end].standing & bit) == 0)
            ++end;
        if (end == m_steps.size() || end - t > m_longestGap ||
            (placeAt(end, foot) - placeAt(t - 1, foot)).norm() > longestCarry * m_stances.height)
            continue;
        for (std::size_t g = t; g < end; ++g)
            m_steps[g].standing |= bit;
    }
}

double FootFollower::driftOf(std::size_t foot) const
{
    const auto stands = [&](std::size_t t) { return (m_steps[t].standing >> foot & 1U) != 0; };
    double greatest = 0;
    for (std::size_t first = 0; first < m_steps.size(); ++first) {
        if (!stands(first))
            continue;
        std::size_t last = first;
        while (last + 1 < m_steps.size() && stands(last + 1))
            ++last;
        const auto weightAt = [&](std::size_t t) {
            return 1 + (t == 0 ? standsBefore(m_steps.front().source, foot) : 0) +
                   (t + 1 == m_steps.size() ? standsBehind(m_steps.back().destination, foot) : 0);
        };
        Vec2d mean = Vec2d::Zero();
        int sum = 0;
        for (std::size_t t = first; t <= last; ++t) {
            mean += weightAt(t) * placeAt(t, foot);
            sum += weightAt(t);
        }
        mean /= sum;
        for (std::size_t t = first; t <= last; ++t)
            greatest = std::max(greatest, (placeAt(t, foot) - mean).norm());
        first = last;
    }
    return greatest;
}

double FootFollower::drift(NodeIndex i, NodeIndex j, int length, int sourceWindow, int destinationWindow)
{
    setSteps(i, j, length, sourceWindow, destinationWindow);
    Step& front = m_steps.front();
    front.destinationTurn.angle() = static_cast<double>(m_roots.turns(front.source, front.destination));
    m_centres.assign(1, Vec2d::Zero());
    for (std::size_t t = 1; t < m_steps.size(); ++t) {
        turn(m_steps[t], m_steps[t - 1]);
        m_centres.push_back(m_centres.back() + wayOfCentre(m_steps[t - 1], m_steps[t]));
    }
    double greatest = 0;
    for (std::size_t foot = 0; foot < m_feet; ++foot) {
        closeGaps(foot);
        greatest = std::max(greatest, driftOf(foot));
    }
    return greatest;
}

} // namespace

Table<float> footDrifts(const RootPoses& roots, const FrameLayout& layout, const TransitionTable& transitions,
                        double fps, const Progress& progress)
{
    const NodeIndex frames = layout.frameCount();
    Table<float> drifts = Table<float>::Zero(frames, frames);
    const double height = roots.stances.height;
    if (!roots.stances.isKnown() || height <= 0)
        return drifts;
    std::atomic<std::int64_t> done = 0;
    tbb::parallel_for(NodeIndex{0}, frames, [&](NodeIndex i) {
        FootFollower follower(roots, layout, fps);
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
