// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/variations.h"

#include "model/core/random.h"
#include "model/synthesis/finishing/contactcorrection.h"
#include "model/variation/latentblend.h"
#include "model/variation/playback.h"
#include "model/variation/posespread.h"
#include "model/variation/preblend.h"
#include "model/variation/rootpath.h"
#include "model/variation/samemovement.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Of what variations differ in height and tilt from what they vary, seconds: a jump that rises at another
/// speed would else land half a metre above the ground, or below.
constexpr double driftHalfLife = 0.08;

/// Draws of the tempo are no further from the mean, in standard deviations.
constexpr double greatestTempo = 2;
/// Logarithm of a duration's factor, at most: at a tenth quicker all accelerations are a fifth higher.
constexpr double greatestTempoChange = 0.1;

/// The captured takes of a subject. \param layout  their frames.
std::vector<OriginTake> originTakes(const Movement& movement, const VariationSubject& subject,
                                    const FrameLayout& layout)
{
    std::vector<OriginTake> takes;
    for (const auto& [index, share] : capturedShares(movement, subject))
        takes.push_back({{&movement.take(index).warp, share}, layout.firstOf(static_cast<int>(index))});
    return takes;
}

TakeWarp warpOfSubject(const Movement& movement, const VariationSubject& subject)
{
    std::vector<WarpShare> warps;
    for (const auto& [index, share] : capturedShares(movement, subject))
        warps.push_back({&movement.take(index).warp, share});
    return blendedWarp(warps);
}

/// When the frames of a variation are played. \param range  that its tempo is drawn from.
TempoPlayback tempoOf(const Movement& movement, const VariationSubject& subject, const WayRange& range,
                      const VariationPoses& settings)
{
    const std::vector<double> playback = warpOfSubject(movement, subject).playback;
    std::vector<bool> stands(playback.size(), true);
    if (settings.tempo > 0 && settings.standing != nullptr) {
        const auto origins =
            variationOrigins(originTakes(movement, subject, settings.standing->character.layout()));
        for (std::size_t f = 0; f < stands.size(); ++f)
            stands[f] =
                !settings.standing->supports[static_cast<std::size_t>(origins[f].nearest())].vertices.empty();
        if (std::ranges::none_of(stands, [](bool stand) { return stand; }))
            stands.assign(stands.size(), true);
    }
    // A stream of its own, that poses do not draw from.
    constexpr std::uint64_t tempoStream = 0x7E3E0;
    Random random(streamSeed(settings.seed, tempoStream));
    const double drawn = std::clamp(random.normal(), -greatestTempo, greatestTempo);
    const double tempo =
        std::clamp(settings.tempo * range.tempo * drawn, -greatestTempoChange, greatestTempoChange);
    return inTempo(playback, stands, tempo);
}

/// Whether the frames of a take are one cycle; pre-blends are where the reference is.
bool isCycle(const Movement& movement, std::size_t take)
{
    const Alignment& alignment = movement.alignment;
    return alignment.cycle && (take == alignment.reference || take >= movement.capturedCount() ||
                               alignment.reports[take].use == TakeUse::Cycle);
}

/// The takes of the same movement as each of those that are varied.
std::vector<SpreadGroup> spreadGroups(const Movement& movement, std::size_t part,
                                      const VariationSubject& subject)
{
    std::vector<SpreadGroup> groups;
    for (const BlendShare& each : capturedShares(movement, subject)) {
        SpreadGroup& group = groups.emplace_back();
        group.share = each.share;
        for (const std::size_t take : sameMovement(movement, each.take))
            group.takes.push_back(movement.training.at(part).spans.at(take));
    }
    return groups;
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
    const PoseSpread poses(state, posesOnParent(training, body), spreadGroups(movement, part, subject),
                           std::ssize(body.vertices), Progress(progress.token()));
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
                                            .times = movement.take(around[c].take).warp.positions,
                                            .closes = isCycle(movement, around[c].take)},
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

LatentVariations sampleLatents(const LearnedMovement& learned, const VariationSubject& subject, int count,
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
    takes.reserve(shares.size());
    for (const auto& [index, share] : shares)
        takes.push_back({&movement.take(index), share});
    const WayRange range = wayRange(movement, subject, settings.up);
    const std::vector<RigidMotion> guide = blendedPlacements(takes, settings.up);
    TakeWarp warp = warpOfSubject(movement, subject);
    const std::vector<Displacement> displacements =
        partDisplacements(rows.front(), movement.training.front(), warp);
    const std::vector<RigidMotion> placements =
        boundedPath(displacements, guide, range,
                    {.up = settings.up, .fps = movement.alignment.fps, .driftHalfLife = driftHalfLife});
    Clip clip;
    clip.topology = movement.topology;
    clip.fps = movement.alignment.fps;
    const TempoPlayback tempo = tempoOf(movement, subject, range, settings);
    warp.playback = tempo.positions;
    clip.positions = played(poses, placements, warp, progress.part(0.9, 1));
    const std::vector<FrameProvenance> origins = variationOrigins(originTakes(movement, subject, layout));
    for (const std::size_t frame : tempo.nearest)
        clip.origins.push_back(origins[frame]);
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
    const TempoPlayback tempo =
        tempoOf(movement, subject, wayRange(movement, subject, settings.up), settings);
    std::vector<RowMatrix> coefficients;
    const std::vector<BlockColumns>& blocks = movement.training.front().blocks;
    if (blocks.size() < 2)
        return coefficients;
    const RowMatrix rows = partRows(learned, 0, latents.front(), settings);
    for (const BlockColumns& block : std::span(blocks).subspan(1))
        coefficients.push_back(valuesAt(blockValues(rows, block), tempo.positions));
    return coefficients;
}

} // namespace quadrille
