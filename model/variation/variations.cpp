// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/variations.h"

#include "model/core/badargument.h"
#include "model/core/random.h"
#include "model/variation/playback.h"
#include "model/variation/preblend.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// A learned weight of a blend and the take that has it.
struct Knot
{
    double weight = 0;
    std::size_t take = 0;
};

/// The learned trajectories from one take to another, ascending by weight.
std::vector<Knot> knotsOf(const Movement& movement, std::size_t from, std::size_t to)
{
    std::vector<Knot> knots{{0, from}, {1, to}};
    for (std::size_t b = 0; b < movement.blends.size(); ++b) {
        const MovementBlend& blend = movement.blends[b];
        const bool isSame = blend.from == from && blend.to == to;
        const bool isReversed = blend.from == to && blend.to == from;
        if (!isSame && !isReversed)
            continue;
        for (std::size_t w = 0; w < blend.weights.size(); ++w)
            knots.push_back({isSame ? blend.weights[w] : 1 - blend.weights[w], movement.blendedTake(b, w)});
    }
    std::sort(knots.begin(), knots.end(), [](const Knot& a, const Knot& b) { return a.weight < b.weight; });
    return knots;
}

/// Pose vectors of a part, one row for each frame.
RowMatrix partRows(const LearnedMovement& learned, std::size_t part, const RowMatrix& latents,
                   const VariationPoses& settings)
{
    const PoseReconstruction& poses = learned.poses(part);
    return settings.draw == PoseDraw::Mean ? poses.means(latents)
                                           : poses.draw(latents, streamSeed(settings.seed, part));
}

/// Of each part its pose vectors.
std::vector<RowMatrix> allRows(const LearnedMovement& learned, const LatentVariation& latents,
                               const VariationPoses& settings)
{
    std::vector<RowMatrix> rows(latents.size());
    tbb::parallel_for(std::size_t{0}, latents.size(),
                      [&](std::size_t p) { rows[p] = partRows(learned, p, latents[p], settings); });
    return rows;
}

std::vector<Vec3f> stitched(const LearnedMovement& learned, const std::vector<RowMatrix>& rows,
                            const Progress& progress)
{
    std::vector<std::vector<Vec3f>> parts(rows.size());
    for (std::size_t p = 0; p < rows.size(); ++p) {
        const std::size_t vertices = learned.stitching().parts().parts[p].vertices.size();
        const auto frames = static_cast<std::size_t>(rows[p].rows());
        parts[p].resize(frames * vertices);
        for (std::size_t f = 0; f < frames; ++f) {
            const auto row = rows[p].row(static_cast<Eigen::Index>(f));
            partPose({row.data(), static_cast<std::size_t>(row.size())},
                     MutablePositions(parts[p]).subspan(f * vertices, vertices));
        }
    }
    std::vector<Positions> views(parts.begin(), parts.end());
    return stitchFrames(learned.stitching(), views, progress);
}

} // namespace

LearnedMovement::LearnedMovement(std::shared_ptr<const Movement> movement, std::vector<GpdmState> states)
    : m_movement(std::move(movement))
    , m_states(std::move(states))
    , m_stitching(m_movement->topology, m_movement->parts, m_movement->alignment.templatePose)
{
    for (std::size_t p = 0; p < m_states.size(); ++p) {
        const PartTraining& training = m_movement->training.at(p);
        m_dynamics.emplace_back(m_states[p], training.spans);
        m_poses.emplace_back(m_states[p], training.rows, training.mean);
    }
}

RowMatrix LearnedMovement::trajectory(std::size_t part, std::size_t take) const
{
    const RowSpan& span = m_movement->training.at(part).spans.at(take);
    return m_states.at(part).latents.middleRows(span.first, span.count);
}

SubjectTakes subjectTakes(const Movement& movement, const VariationSubject& subject)
{
    const std::size_t count = movement.capturedCount();
    if (subject.take >= count || subject.to.value_or(0) >= count)
        refuse("There is no such take to vary", "Name one of the takes that were learned.");
    if (!subject.to)
        return {subject.take, subject.take, 0};
    if (!(subject.weight >= 0 && subject.weight <= 1))
        refuse("The weight of a blend lies outside of 0 … 1", "Write a weight from 0 to 1.");
    const std::vector<Knot> knots = knotsOf(movement, subject.take, *subject.to);
    std::size_t upper = 1;
    while (knots[upper].weight < subject.weight)
        ++upper;
    const Knot& low = knots[upper - 1];
    const Knot& high = knots[upper];
    return {low.take, high.take, (subject.weight - low.weight) / (high.weight - low.weight)};
}

LatentVariations drawLatents(const LearnedMovement& learned, const VariationSubject& subject, int count,
                             std::uint64_t seed, const HmcSettings& settings, const Progress& progress)
{
    const SubjectTakes takes = subjectTakes(learned.movement(), subject);
    // At a learned weight there is one trajectory to draw around.
    std::vector<std::size_t> around;
    if (takes.weight < 1)
        around.push_back(takes.first);
    if (takes.weight > 0)
        around.push_back(takes.second);
    const std::size_t parts = learned.partCount();
    const std::size_t chains = parts * around.size();
    std::vector<TrajectorySamples> drawn(chains);
    std::vector<std::atomic<double>> fractions(chains);
    tbb::parallel_for(std::size_t{0}, chains, [&](std::size_t c) {
        const std::size_t part = c / around.size();
        const std::size_t which = c % around.size();
        const Progress own(progress.token(), [&, c](double fraction) {
            fractions[c] = fraction;
            double sum = 0;
            for (const auto& each : fractions)
                sum += each;
            progress.report(sum / static_cast<double>(chains));
        });
        drawn[c] = sampleTrajectories(learned.dynamics(part), learned.trajectory(part, around[which]), count,
                                      streamSeed(seed, 2 * part + which), settings, own);
    });
    LatentVariations result;
    result.variations.resize(static_cast<std::size_t>(count), LatentVariation(parts));
    result.chains.resize(parts);
    for (std::size_t p = 0; p < parts; ++p) {
        const TrajectorySamples& first = drawn[p * around.size()];
        const TrajectorySamples& second = drawn[p * around.size() + around.size() - 1];
        for (std::size_t v = 0; v < result.variations.size(); ++v)
            result.variations[v][p] = around.size() == 1 ? first.trajectories[v]
                                                         : (1 - takes.weight) * first.trajectories[v] +
                                                               takes.weight * second.trajectories[v];
        for (std::size_t which = 0; which < around.size(); ++which)
            result.chains[p].push_back(drawn[p * around.size() + which].report);
    }
    return result;
}

std::vector<Vec3f> variationPoses(const LearnedMovement& learned, const LatentVariation& latents,
                                  const VariationPoses& settings, const Progress& progress)
{
    return stitched(learned, allRows(learned, latents, settings), progress);
}

Clip makeVariation(const LearnedMovement& learned, const VariationSubject& subject,
                   const LatentVariation& latents, const FrameLayout& layout, const VariationPoses& settings,
                   const Progress& progress)
{
    subjectTakes(learned.movement(), subject);
    const Movement& movement = learned.movement();
    const std::vector<RowMatrix> rows = allRows(learned, latents, settings);
    const std::vector<Vec3f> poses = stitched(learned, rows, progress.part(0.2, 0.9));
    const AlignedTake& take = movement.take(subject.take);
    const AlignedTake& to = movement.take(subject.to.value_or(subject.take));
    const double weight = subject.to ? subject.weight : 0;
    const TakeWarp warp = weight == 0 ? take.warp : blendedWarp(take.warp, to.warp, weight);
    const std::vector<RigidMotion> guide =
        weight == 0 ? take.placements : blendedPlacements(take.placements, to.placements, weight);
    const RowMatrix& root = rows.front();
    std::vector<Displacement> displacements;
    for (Eigen::Index f = 0; f < root.rows(); ++f)
        displacements.push_back(partDisplacement({root.row(f).data(), static_cast<std::size_t>(root.cols())},
                                                 movement.training.front().displacementScale));
    const std::vector<RigidMotion> placements =
        pathOnGround(displacements, guide, {.up = settings.up, .fps = movement.alignment.fps});
    const int from = static_cast<int>(subject.take);
    Clip clip;
    clip.topology = movement.topology;
    clip.fps = movement.alignment.fps;
    clip.positions = played(poses, placements, warp, progress.part(0.9, 1));
    clip.origins = subject.to ? variationOrigins(take.warp, to.warp, weight, layout.firstOf(from),
                                                 layout.firstOf(static_cast<int>(*subject.to)))
                              : variationOrigins(warp, layout.firstOf(from));
    return clip;
}

} // namespace quadrille
