// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/transitionmotion.h"

#include <cassert>

namespace quadrille {

namespace {

template <typename Value>
Value between(const FrameTime& time, const Value& here, const Value& next)
{
    return time.part > 0 ? Value((1 - time.part) * here + time.part * next) : here;
}

/// Knows where both windows of a transition are at each of its frames.
class Mover
{
public:
    Mover(const RootPoses& roots, std::vector<BlendTimes> times)
        : m_roots(roots), m_ground(roots.up), m_times(std::move(times))
    {
    }

    const BlendTimes& times(std::size_t frame) const { return m_times[frame]; }
    Vec2d source(std::size_t frame) const { return m_ground.of(centre(m_times[frame].source)); }
    Vec2d destination(std::size_t frame) const { return m_ground.of(centre(m_times[frame].destination)); }
    double turn(std::size_t frame) const;
    Vec3d blended(const Vec2d& ground, std::size_t frame, double lambda) const
    {
        return m_ground.at(ground, (1 - lambda) * m_ground.heightOf(centre(m_times[frame].source)) +
                                       lambda * m_ground.heightOf(centre(m_times[frame].destination)));
    }

private:
    Vec3d centre(const FrameTime& time) const
    {
        return between(time, m_roots.centres[static_cast<std::size_t>(time.frame)],
                       m_roots.centres[static_cast<std::size_t>(time.next())]);
    }

    const RootPoses& m_roots;
    Ground m_ground;
    std::vector<BlendTimes> m_times;
};

double Mover::turn(std::size_t frame) const
{
    const auto& [source, destination] = m_times[frame];
    const auto at = [this](NodeIndex row, NodeIndex column) {
        return static_cast<double>(m_roots.turns(row, column));
    };
    const double here = at(source.frame, destination.frame);
    // The other corners as angles near to this one, so that none of them is a turn away.
    const auto near = [&](NodeIndex row, NodeIndex column) {
        return here + wrappedAngle(at(row, column) - here);
    };
    return between(source, between(destination, here, near(source.frame, destination.next())),
                   between(destination, near(source.next(), destination.frame),
                           near(source.next(), destination.next())));
}

Vec2d turned(double angle, const Vec2d& step)
{
    return Eigen::Rotation2Dd(angle) * step;
}

/// Lays the windows over each other anew at every step: both lie with their current centres on the centre of
/// the result and share out the turn between them.
std::vector<TransitionMotion::Step> movedAtEveryStep(const Mover& mover, std::span<const double> lambdas)
{
    std::vector<TransitionMotion::Step> steps;
    Vec2d centre = mover.source(0);
    double sourceTurn = 0;
    double destinationTurn = mover.turn(0);
    for (std::size_t t = 0; t < lambdas.size(); ++t) {
        const double lambda = lambdas[t];
        if (t > 0) {
            const double before = lambdas[t - 1];
            centre += (1 - before) * turned(sourceTurn, mover.source(t) - mover.source(t - 1)) +
                      before * turned(destinationTurn, mover.destination(t) - mover.destination(t - 1));
            sourceTurn -= lambda * wrappedAngle(sourceTurn + mover.turn(t) - destinationTurn);
            destinationTurn = sourceTurn + mover.turn(t);
        }
        steps.push_back(
            {.times = mover.times(t),
             .lambda = lambda,
             .placeSource = GroundMotion::taking(mover.source(t), centre, sourceTurn),
             .placeDestination = GroundMotion::taking(mover.destination(t), centre, destinationTurn),
             .centre = mover.blended(centre, t, lambda)});
    }
    return steps;
}

std::vector<TransitionMotion::Step> movedOnce(const Mover& mover, std::span<const double> lambdas,
                                              const GroundMotion& placeDestination)
{
    std::vector<TransitionMotion::Step> steps;
    for (std::size_t t = 0; t < lambdas.size(); ++t) {
        const Vec2d centre =
            (1 - lambdas[t]) * mover.source(t) + lambdas[t] * placeDestination(mover.destination(t));
        steps.push_back({.times = mover.times(t),
                         .lambda = lambdas[t],
                         .placeDestination = placeDestination,
                         .centre = mover.blended(centre, t, lambdas[t])});
    }
    return steps;
}

} // namespace

TransitionMotion transitionMotion(const RootPoses& roots, const Transition& transition,
                                  const BlendSettings& settings)
{
    const std::size_t count = transition.path.size();
    assert(count > 0);
    std::vector<double> lambdas(count, settings.constantWeight.value_or(0));
    for (std::size_t t = 1; !settings.constantWeight && t < count; ++t) {
        const double even = static_cast<double>(t) / static_cast<double>(count - 1);
        lambdas[t] = settings.easing == BlendEasing::Smooth ? even * even * (3 - 2 * even) : even;
    }
    const Mover mover(roots, blendTimes(transition, settings.timing));
    switch (settings.alignment) {
    case BlendAlignment::EveryStep:
        return {movedAtEveryStep(mover, lambdas)};
    case BlendAlignment::MidWindow:
        return {movedOnce(mover, lambdas,
                          GroundMotion::taking(mover.destination(count / 2), mover.source(count / 2),
                                               mover.turn(count / 2)))};
    case BlendAlignment::None:
        return {movedOnce(mover, lambdas, GroundMotion::taking(mover.destination(0), mover.source(0), 0))};
    }
    return {};
}

} // namespace quadrille
