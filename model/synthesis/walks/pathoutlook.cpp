// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/pathoutlook.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

constexpr double headingStep = 10 * std::numbers::pi / 180;
constexpr double farthest = 0.6;       ///< of the distances to either side of the path, metres
constexpr double directionStep = 0.02; ///< metres
constexpr float lost = 1e6F;           ///< where nothing leads on
constexpr double finestLayer = 0.3;    ///< metres
constexpr double mostTables = 80'000;  ///< of costs to go, 70 MB

/// A place between two of a row, and how far it is from the first to the next.
struct Between
{
    int first = 0;
    float part = 0;
};

/// \param position  counted from 0 on; the nearest one of the row is taken.
Between betweenOf(double position, int count)
{
    const double within = std::clamp(position, 0.0, count - 1.0);
    const int first = std::min(static_cast<int>(within), count - 2);
    return {first, static_cast<float>(within - first)};
}

NodeIndex strideFor(const FrameLayout& layout, double layers)
{
    NodeIndex stride = 4;
    while (stride < 64 && layers * layout.frameCount() / stride > mostTables)
        stride *= 2;
    return stride;
}

} // namespace

PathOutlook::PathOutlook(const WalkGraph& graph, const PathCourse& course, const PathCosts& costs,
                         MoveMotions& motions, double mu, int leastRun, const Progress& progress)
    : m_course(course)
    , m_costs(costs)
    , m_motions(motions)
    , m_mu(mu)
    , m_grid(graph.layout(), strideFor(graph.layout(), course.length() / finestLayer))
    , m_layerLength(std::max(finestLayer, course.length() * static_cast<double>(m_grid.count()) / mostTables))
    , m_layers(static_cast<std::size_t>(std::ceil(course.length() / m_layerLength)))
{
    const StretchMaterial material{
        .graph = graph, .grid = m_grid, .motions = motions, .leastRun = leastRun, .leastWay = m_layerLength};
    constexpr double around = 0.3; ///< metres before and behind
    for (double walked = 0; walked < course.length() + directionStep; walked += directionStep) {
        const double from = std::max(0.0, walked - around);
        m_directions.push_back(course.directionFrom(from, walked + around - from));
    }
    for (std::size_t frame = 0; frame < m_grid.count(); ++frame)
        m_headings.push_back(motions.headingAt(m_grid.frame(frame)));
    const std::vector<std::vector<Stretch>> stretches = stretchesOf(material);
    m_costsToGo.assign(m_layers * m_grid.count(), Cells::Constant(lost));
    for (std::size_t layer = m_layers; layer-- > 0;) {
        progress.report(0);
        tbb::parallel_for(std::size_t{0}, m_grid.count(),
                          [&](std::size_t frame) { fill(layer, frame, stretches[frame]); });
    }
}

/// The distances lie closer together near the path, where they decide.
double PathOutlook::sideOf(int index)
{
    const double part = static_cast<double>(index - sidesEach) / sidesEach;
    return farthest * part * std::abs(part);
}

double PathOutlook::directionAt(double walked) const
{
    return m_directions[std::min(static_cast<std::size_t>(walked / directionStep), m_directions.size() - 1)];
}

PathOutlook::Cells PathOutlook::cellsAt(std::size_t frame, double walked) const
{
    const double position = std::max(walked, 0.0) / m_layerLength;
    const auto layer = static_cast<std::size_t>(position);
    if (layer >= m_layers)
        return Cells::Zero();
    const auto part = static_cast<float>(position - static_cast<double>(layer));
    const Cells& near = m_costsToGo[layer * m_grid.count() + frame];
    if (layer + 1 == m_layers)
        return (1 - part) * near;
    return near + part * (m_costsToGo[(layer + 1) * m_grid.count() + frame] - near);
}

PathOutlook::Bend PathOutlook::bendAlong(const Stretch& stretch, double walked) const
{
    const Vec3d origin = m_course.at(walked);
    const double direction = directionAt(walked);
    const Eigen::Rotation2Dd intoPath(-direction);
    Bend bend;
    for (const Stretch::Sample& sample : stretch.samples) {
        const Vec3d there = m_course.at(walked + sample.walked);
        const Vec2d ground = intoPath * Vec2d((there - origin).head<2>());
        bend.ways.emplace_back(ground.x(), ground.y(), there.z());
    }
    bend.turn = wrappedAngle(directionAt(walked + stretch.samples.back().walked) - direction);
    return bend;
}

/// Costs to go at the end of a stretch. \param turn  of the heading against the path meanwhile.
PathOutlook::Cells PathOutlook::after(const Stretch& stretch, double end, double turn) const
{
    const Cells cells = cellsAt(stretch.to, end);
    const double shift = wrappedAngle(turn) / headingStep;
    const int whole = static_cast<int>(std::floor(shift));
    const auto part = static_cast<float>(shift - whole);
    Cells turned = Cells::Constant(lost);
    for (int heading = 0; heading < headingCount; ++heading) {
        const int first = heading + whole;
        if (first >= 0 && first + 1 < headingCount)
            turned.row(heading) = cells.row(first) + part * (cells.row(first + 1) - cells.row(first));
    }
    return turned;
}

void PathOutlook::addObstructions(const Stretch& stretch, double walked, double facing, Cells& costs) const
{
    const bool missesSpan = std::ranges::any_of(stretch.samples, [&](const Stretch::Sample& sample) {
        return m_costs.missedSpan(walked + sample.walked, sample.source, sample.destination) >= 0;
    });
    if (missesSpan)
        costs.setConstant(lost);
    if (missesSpan || !m_course.hasObstacles())
        return;
    const Vec3d origin = m_course.at(walked);
    const Eigen::Rotation2Dd outOfPath(directionAt(walked));
    for (int heading = 0; heading < headingCount; ++heading) {
        const Eigen::Rotation2Dd turned(facing + headingStep * heading);
        for (int side = 0; side < sideCount; ++side) {
            const bool isObstructed =
                std::ranges::any_of(stretch.samples, [&](const Stretch::Sample& sample) {
                    const Vec2d way = turned * Vec2d(sample.point.head<2>()) + Vec2d(0, sideOf(side));
                    return m_course.obstacleAt(origin.head<2>() + outOfPath * way) >= 0;
                });
            if (isObstructed)
                costs(heading, side) = lost;
        }
    }
}

PathOutlook::Facing PathOutlook::facingAt(std::size_t frame) const
{
    Facing facing{.first = -m_headings[frame] - headingStep * (headingCount - 1) / 2.0};
    for (int heading = 0; heading < headingCount; ++heading) {
        facing.cosines[heading] = static_cast<float>(std::cos(facing.first + headingStep * heading));
        facing.sines[heading] = static_cast<float>(std::sin(facing.first + headingStep * heading));
    }
    return facing;
}

PathOutlook::Passage PathOutlook::passageOf(const Stretch& stretch, const Bend& bend, double walked,
                                            const Facing& facing) const
{
    Passage passage;
    passage.costs.setConstant(static_cast<float>(m_mu * stretch.weight));
    const auto deadZone = static_cast<float>(m_costs.deadZone());
    for (std::size_t i = 0; i < stretch.samples.size(); ++i) {
        const Stretch::Sample& sample = stretch.samples[i];
        if (i > 0 && walked + stretch.samples[i - 1].walked >= m_course.length())
            break;
        const Eigen::Vector3f there = sample.point.cast<float>();
        const Eigen::Vector3f way = bend.ways[i].cast<float>();
        passage.along = facing.cosines * there.x() - facing.sines * there.y() - way.x();
        passage.left = facing.sines * there.x() + facing.cosines * there.y() - way.y();
        const float height = there.z() - way.z();
        const auto factor = static_cast<float>(m_costs.factor(sample.way, sample.frames));
        for (int side = 0; side < sideCount; ++side) {
            const Headings left = passage.left + static_cast<float>(sideOf(side));
            const Headings off = (passage.along.square() + left.square() + height * height).sqrt();
            passage.costs.col(side) += factor * (off - deadZone).max(0.0F).square();
        }
    }
    addObstructions(stretch, walked, facing.first, passage.costs);
    return passage;
}

/// \param turn  of the path during the passage. \param shift  to the left at its end, metres.
/// \param toGo  from its end.
void PathOutlook::keepLeast(const Passage& passage, double turn, double shift, const Cells& toGo, Cells& best)
{
    const auto c = static_cast<float>(std::cos(turn));
    const auto s = static_cast<float>(std::sin(turn));
    for (int side = 0; side < sideCount; ++side) {
        const Headings sides =
            c * (passage.left + static_cast<float>(sideOf(side) + shift)) - s * passage.along;
        const Headings parts = (sides.abs() * static_cast<float>(1 / farthest)).min(1.0F).sqrt();
        const Headings positions = static_cast<float>(sidesEach) * (1 + parts * sides.sign());
        for (int heading = 0; heading < headingCount; ++heading) {
            float& least = best(heading, side);
            if (passage.costs(heading, side) >= least)
                continue;
            const int first = std::min(static_cast<int>(positions[heading]), sideCount - 2);
            const float after = std::lerp(toGo(heading, first), toGo(heading, first + 1),
                                          positions[heading] - static_cast<float>(first));
            least = std::min(least, passage.costs(heading, side) + after);
        }
    }
}

/// By how much a stretch is turned towards the path: not at all, or as far as may be to either side.
PathOutlook::Turns PathOutlook::turnsOf(const Stretch& stretch) const
{
    double frames = 0;
    for (const Stretch::Sample& sample : stretch.samples)
        frames += sample.frames;
    const double most = m_costs.steering().most(stretch.samples.back().walked, frames);
    return {.angles = {0, -most, most}, .count = most > 0 ? std::size_t{3} : std::size_t{1}};
}

void PathOutlook::fill(std::size_t layer, std::size_t frame, const std::vector<Stretch>& stretches)
{
    Cells& best = m_costsToGo[layer * m_grid.count() + frame];
    const double walked = m_layerLength * static_cast<double>(layer);
    const Facing facing = facingAt(frame);
    for (const Stretch& stretch : stretches) {
        const double end = walked + stretch.samples.back().walked;
        if (!stretch.leadsOn && end < m_course.length())
            continue;
        const Bend bend = bendAlong(stretch, walked);
        const double turn = m_headings[stretch.to] + stretch.turn - m_headings[frame] - bend.turn;
        const Turns turns = turnsOf(stretch);
        std::optional<Passage> passage;
        for (const double steered : std::span(turns.angles).first(turns.count)) {
            const Cells toGo = end < m_course.length() ? after(stretch, end, turn + steered) : Cells::Zero();
            if (static_cast<float>(m_mu * stretch.weight) + toGo.minCoeff() >= best.maxCoeff())
                continue;
            if (!passage)
                passage = passageOf(stretch, bend, walked, facing);
            const double shift = steered / 2 * stretch.samples.back().walked;
            keepLeast(*passage, bend.turn, shift, toGo, best);
        }
    }
}

double PathOutlook::cost(NodeIndex node, double walked, const GroundMotion& placement) const
{
    const std::size_t frame = m_grid.before(node);
    const double there = std::max(walked + m_motions.wayBetween(node, m_grid.frame(frame)), 0.0);
    const Vec3d& point = m_motions.point(m_grid.frame(frame));
    const Vec3d path = m_course.at(there);
    const double direction = directionAt(there);
    const Vec2d off = placement(Vec2d(point.head<2>())) - path.head<2>();
    const double side = off.y() * std::cos(direction) - off.x() * std::sin(direction);
    // What the grid does not know: how far along the path it is off, how far out, and how far round.
    constexpr double mendingWay = 1; ///< metres
    constexpr double mendingFrames = 20;
    constexpr double mendingTurn = 10; ///< for each radian
    const double away = std::hypot(off.norm(), point.z() - path.z());
    const double known = std::min(std::abs(side), farthest);
    const double beside = m_costs.deviation(away, mendingWay, mendingFrames) -
                          m_costs.deviation(known, mendingWay, mendingFrames);
    const double heading = wrappedAngle(placement.turn + m_headings[frame] - direction);
    const double round = std::max(0.0, std::abs(heading) - headingStep * (headingCount - 1) / 2.0);
    const Between sides =
        betweenOf(sidesEach * (1 + std::copysign(std::sqrt(known / farthest), side)), sideCount);
    const Between headings = betweenOf(heading / headingStep + (headingCount - 1) / 2.0, headingCount);
    const double position = there / m_layerLength;
    const auto layer = static_cast<std::size_t>(position);
    const auto costIn = [&](std::size_t index) {
        if (index >= m_layers)
            return 0.0F;
        const Cells& cells = m_costsToGo[index * m_grid.count() + frame];
        const auto row = [&](int first) {
            return std::lerp(cells(first, sides.first), cells(first, sides.first + 1), sides.part);
        };
        return std::lerp(row(headings.first), row(headings.first + 1), headings.part);
    };
    const auto part = static_cast<float>(position - static_cast<double>(layer));
    return std::max(beside, 0.0) + mendingTurn * round +
           static_cast<double>(std::lerp(costIn(layer), costIn(layer + 1), part));
}

} // namespace quadrille
