// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/variations.h"

#include "model/core/random.h"
#include "model/synthesis/contactcorrection.h"
#include "model/variation/latentblend.h"
#include "model/variation/playback.h"
#include "model/variation/posespread.h"
#include "model/variation/preblend.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Of what variations differ in height and tilt from what they vary, seconds: a jump that rises at another
/// speed would else land half a metre above the ground, or below.
constexpr double driftHalfLife = 0.08;

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
                  learnedPoses(*m_movement), ChildLaying::Moved)
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

PartVariations drawPart(const Movement& movement, std::size_t part, const GpdmState& state,
                        const VariationSubject& subject, int count, std::uint64_t seed,
                        const SamplingSettings& settings, const Progress& progress)
{
    const std::vector<BlendShare> around = subjectTakes(movement, subject);
    const PartTraining& training = movement.training.at(part);
    const std::vector<RowSpan>& spans = training.spans;
    const GpdmDynamics dynamics(state, spans);
    const BodyPart& body = movement.parts.parts.at(part);
    const PoseSpread poses(state, posesOnParent(training, body),
                           std::span(spans).first(movement.capturedCount()), std::ssize(body.vertices),
                           Progress(progress.token()));
    double squares = 0;
    for (const BlendShare& each : around)
        squares += each.share * each.share;
    SamplingSettings own = settings;
    own.limits.spread /= std::sqrt(squares);
    PartVariations result;
    std::vector<TrajectorySamples> drawn;
    for (std::size_t c = 0; c < around.size(); ++c) {
        const RowSpan& span = spans.at(around[c].take);
        const double share = 1.0 / static_cast<double>(around.size());
        const auto at = static_cast<double>(c);
        drawn.push_back(sampleTrajectories(dynamics, poses,
                                           {.positions = state.latents.middleRows(span.first, span.count),
                                            .times = movement.take(around[c].take).warp.positions},
                                           count, streamSeed(streamSeed(seed, part), around[c].take), own,
                                           progress.part(at * share, (at + 1) * share)));
        result.reports.push_back(drawn.back().report);
    }
    for (std::size_t v = 0; v < static_cast<std::size_t>(count); ++v) {
        std::vector<LatentShare> shares;
        for (std::size_t c = 0; c < around.size(); ++c)
            shares.push_back({std::move(drawn[c].trajectories[v]), around[c].share});
        result.trajectories.push_back(latentBlend(shares));
    }
    return result;
}

LatentVariations drawLatents(const LearnedMovement& learned, const VariationSubject& subject, int count,
                             std::uint64_t seed, const SamplingSettings& settings, const Progress& progress)
{
    subjectTakes(learned.movement(), subject);
    const std::size_t parts = learned.partCount();
    LatentVariations result;
    result.variations.resize(static_cast<std::size_t>(count), LatentVariation(parts));
    result.reports.resize(parts);
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
        result.reports[p] = std::move(drawn.reports);
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
    const Movement& movement = learned.movement();
    const std::vector<BlendShare> shares = capturedShares(movement, subject);
    const std::vector<RowMatrix> rows = allRows(learned, latents, settings);
    const std::vector<Vec3f> poses = stitched(learned, rows, progress.part(0.2, 0.9));
    std::vector<TakeShare> takes;
    std::vector<OriginTake> origins;
    std::vector<WarpShare> warps;
    for (const auto& [index, share] : shares) {
        const AlignedTake& take = movement.take(index);
        takes.push_back({&take, share});
        warps.push_back({&take.warp, share});
        origins.push_back({warps.back(), layout.firstOf(static_cast<int>(index))});
    }
    const TakeWarp warp = blendedWarp(warps);
    const std::vector<RigidMotion> guide = blendedPlacements(takes, settings.up);
    const RowMatrix& root = rows.front();
    const std::vector<Displacement> displacements = partDisplacements(root, movement.training.front(), warp);
    const std::vector<RigidMotion> placements =
        pathOnGround(displacements, guide,
                     {.up = settings.up, .fps = movement.alignment.fps, .driftHalfLife = driftHalfLife});
    Clip clip;
    clip.topology = movement.topology;
    clip.fps = movement.alignment.fps;
    clip.positions = played(poses, placements, warp, progress.part(0.9, 1));
    clip.origins = variationOrigins(origins);
    if (settings.standing)
        keepStanding(clip, *settings.standing, settings.up);
    if (settings.contacts && !settings.contacts->legs.feet.empty()) {
        const std::vector<ContactSpan> contacts = contactsOf(clip, settings.contacts->character);
        clip = contactsCorrected(
            std::move(clip), contacts, {},
            {.up = settings.up, .frames = {}, .legs = &settings.contacts->legs, .trustsLegs = true},
            Progress(progress.token()));
    }
    return clip;
}

std::vector<RowMatrix> variationCoefficients(const LearnedMovement& learned, const VariationSubject& subject,
                                             const LatentVariation& latents, const VariationPoses& settings)
{
    const Movement& movement = learned.movement();
    std::vector<WarpShare> warps;
    for (const auto& [index, share] : capturedShares(movement, subject))
        warps.push_back({&movement.take(index).warp, share});
    const TakeWarp warp = blendedWarp(warps);
    std::vector<RowMatrix> coefficients;
    const std::vector<BlockColumns>& blocks = movement.training.front().blocks;
    if (blocks.size() < 2)
        return coefficients;
    const RowMatrix rows = partRows(learned, 0, latents.front(), settings);
    for (const BlockColumns& block : std::span(blocks).subspan(1))
        coefficients.push_back(valuesAt(blockValues(rows, block), warp.playback));
    return coefficients;
}

} // namespace quadrille
