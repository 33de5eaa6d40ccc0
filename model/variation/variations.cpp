// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/variations.h"

#include "model/core/badargument.h"
#include "model/core/random.h"
#include "model/variation/latentblend.h"
#include "model/variation/playback.h"
#include "model/variation/preblend.h"
#include "model/variation/standing.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// A learned weight of a blend and the take that has it.
struct LearnedWeight
{
    double weight = 0;
    std::size_t take = 0;
};

/// The learned trajectories from one take to another, ascending by weight.
std::vector<LearnedWeight> learnedWeights(const Movement& movement, std::size_t from, std::size_t to)
{
    std::vector<LearnedWeight> learned{{0, from}, {1, to}};
    for (std::size_t b = 0; b < movement.blends.size(); ++b) {
        const MovementBlend& blend = movement.blends[b];
        const bool isSame = blend.from == from && blend.to == to;
        const bool isReversed = blend.from == to && blend.to == from;
        if (!isSame && !isReversed)
            continue;
        for (std::size_t w = 0; w < blend.weights.size(); ++w)
            learned.push_back({isSame ? blend.weights[w] : 1 - blend.weights[w], movement.blendedTake(b, w)});
    }
    std::sort(learned.begin(), learned.end(),
              [](const LearnedWeight& a, const LearnedWeight& b) { return a.weight < b.weight; });
    return learned;
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

/// All poses learned from: they tell how far triangles stretch.
std::vector<Positions> learnedPoses(const Movement& movement)
{
    const std::size_t count = movement.topology->vertexCount();
    std::vector<Positions> poses;
    for (const AlignedTake& take : movement.alignment.takes) {
        for (std::size_t at = 0; at < take.poses.size(); at += count)
            poses.push_back(Positions(take.poses).subspan(at, count));
    }
    return poses;
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
    , m_stitching(m_movement->topology, m_movement->parts, m_movement->alignment.templatePose,
                  learnedPoses(*m_movement))
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
    const std::vector<LearnedWeight> learned = learnedWeights(movement, subject.take, *subject.to);
    std::vector<double> weights;
    weights.reserve(learned.size());
    for (const LearnedWeight& each : learned)
        weights.push_back(each.weight);
    const BlendNeighbours between = blendNeighbours(weights, subject.weight);
    return {learned[between.first].take, learned[between.second].take, 1 - between.share};
}

PartVariations drawPart(const Movement& movement, std::size_t part, const GpdmState& state,
                        const VariationSubject& subject, int count, std::uint64_t seed,
                        const HmcSettings& settings, const Progress& progress)
{
    const SubjectTakes takes = subjectTakes(movement, subject);
    const std::vector<RowSpan>& spans = movement.training.at(part).spans;
    const GpdmDynamics dynamics(state, spans);
    // At a learned weight there is one trajectory to draw around.
    std::vector<std::size_t> around;
    if (takes.weight < 1)
        around.push_back(takes.first);
    if (takes.weight > 0)
        around.push_back(takes.second);
    std::vector<TrajectorySamples> drawn;
    for (std::size_t c = 0; c < around.size(); ++c) {
        const RowSpan& span = spans.at(around[c]);
        const double share = 1.0 / static_cast<double>(around.size());
        const auto at = static_cast<double>(c);
        drawn.push_back(sampleTrajectories(dynamics, state.latents.middleRows(span.first, span.count), count,
                                           streamSeed(seed, 2 * part + c), settings,
                                           progress.part(at * share, (at + 1) * share)));
    }
    PartVariations result;
    for (std::size_t v = 0; v < static_cast<std::size_t>(count); ++v)
        result.trajectories.push_back(
            around.size() == 1
                ? drawn.front().trajectories[v]
                : latentBlend(drawn[0].trajectories[v], drawn[1].trajectories[v], 1 - takes.weight));
    for (TrajectorySamples& samples : drawn)
        result.chains.push_back(std::move(samples.report));
    return result;
}

LatentVariations drawLatents(const LearnedMovement& learned, const VariationSubject& subject, int count,
                             std::uint64_t seed, const HmcSettings& settings, const Progress& progress)
{
    subjectTakes(learned.movement(), subject);
    const std::size_t parts = learned.partCount();
    LatentVariations result;
    result.variations.resize(static_cast<std::size_t>(count), LatentVariation(parts));
    result.chains.resize(parts);
    std::vector<std::atomic<double>> fractions(parts);
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t p) {
        const Progress own(progress.token(), [&, p](double fraction) {
            fractions[p] = fraction;
            double sum = 0;
            for (const auto& each : fractions)
                sum += each;
            progress.report(sum / static_cast<double>(parts));
        });
        PartVariations drawn =
            drawPart(learned.movement(), p, learned.state(p), subject, count, seed, settings, own);
        for (std::size_t v = 0; v < result.variations.size(); ++v)
            result.variations[v][p] = std::move(drawn.trajectories[v]);
        result.chains[p] = std::move(drawn.chains);
    });
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
        weight == 0 ? take.placements
                    : blendedPlacements(take.placements, to.placements, weight, settings.up);
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
    if (!settings.supports.empty())
        keepStanding(clip, settings.supports, settings.up);
    return clip;
}

} // namespace quadrille
