// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/transitionmotion.h"

#include <cassert>

namespace quadrille {

namespace {

/// Walks along the path of one transition.
class Mover
{
public:
    Mover(const RootPoses& roots, const Transition& transition)
        : m_roots(roots), m_ground(roots.up), m_path(transition.path)
    {
    }

    Vec2d source(std::size_t cell) const { return m_ground.of(centre(m_path[cell].source)); }
    Vec2d destination(std::size_t cell) const { return m_ground.of(centre(m_path[cell].destination)); }
    double turn(std::size_t cell) const
    {
        return static_cast<double>(m_roots.turns(m_path[cell].source, m_path[cell].destination));
    }
    Vec3d blended(const Vec2d& ground, std::size_t cell, double lambda) const
    {
        return m_ground.at(ground, (1 - lambda) * m_ground.heightOf(centre(m_path[cell].source)) +
                                       lambda * m_ground.heightOf(centre(m_path[cell].destination)));
    }

private:
    const Vec3d& centre(NodeIndex node) const { return m_roots.centres[static_cast<std::size_t>(node)]; }

    const RootPoses& m_roots;
    Ground m_ground;
    const std::vector<FramePair>& m_path;
};

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
            const auto turned = [](double angle, const Vec2d& step) -> Vec2d {
                return Eigen::Rotation2Dd(angle) * step;
            };
            centre +=
                (1 - lambdas[t - 1]) * turned(sourceTurn, mover.source(t) - mover.source(t - 1)) +
                lambdas[t - 1] * turned(destinationTurn, mover.destination(t) - mover.destination(t - 1));
            sourceTurn -= lambda * wrappedAngle(sourceTurn + mover.turn(t) - destinationTurn);
            destinationTurn = sourceTurn + mover.turn(t);
        }
        steps.push_back(
            {.lambda = lambda,
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
        steps.push_back({.lambda = lambdas[t],
                         .placeDestination = placeDestination,
                         .centre = mover.blended(centre, t, lambdas[t])});
    }
    return steps;
}

} // namespace

TransitionMotion transitionMotion(const RootPoses& roots, const Transition& transition,
                                  BlendAlignment alignment, std::optional<double> constantWeight)
{
    const std::size_t count = transition.path.size();
    assert(count > 0);
    std::vector<double> lambdas(count, constantWeight.value_or(0));
    for (std::size_t t = 1; !constantWeight && t < count; ++t)
        lambdas[t] = static_cast<double>(t) / static_cast<double>(count - 1);
    const Mover mover(roots, transition);
    switch (alignment) {
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
