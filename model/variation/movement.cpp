// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/movement.h"

#include "model/core/badargument.h"
#include "model/variation/preblend.h"

#include <atomic>
#include <mutex>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// Makes all pre-blends of a movement, each one as another take of its alignment.
void addPreblends(Movement& movement, const MovementSettings& settings, const Progress& progress)
{
    std::vector<AlignedTake>& takes = movement.alignment.takes;
    std::vector<std::string> names;
    names.reserve(takes.size());
    for (const AlignedTake& take : takes)
        names.push_back(take.name);
    const auto system = std::make_shared<const PoissonSystem>(movement.topology);
    const double share = 1.0 / static_cast<double>(movement.preblends.size());
    double done = 0;
    for (const Preblend& point : movement.preblends) {
        const MovementBlend& blend = movement.blends[point.blend];
        std::vector<TakeShare> of;
        for (const BlendShare& each : sharesOf(blend, point))
            of.push_back({&takes[each.take], each.share});
        takes.push_back(blendedTake(system, of, preblendName(blend, point, names),
                                    {.up = settings.alignment.up, .method = settings.interpolation},
                                    progress.part(done * share, (done + 1) * share)));
        ++done;
    }
}

/// Warps what was captured with the frames to the reference.
void alignCoefficients(std::span<const TrainingTake> captured, std::size_t kinds,
                       std::vector<AlignedTake>& takes)
{
    for (std::size_t t = 0; t < captured.size(); ++t) {
        const std::vector<RowMatrix>& given = captured[t].coefficients;
        if (given.size() != kinds)
            refuse("A take has not one list of coefficients for each kind", "Give as many to all takes.");
        for (std::size_t k = 0; k < kinds; ++k) {
            if (given[k].rows() != captured[t].sequence.frameCount() ||
                given[k].cols() != captured.front().coefficients[k].cols())
                refuse("A take has not as many coefficients in each frame as the others",
                       "Give a row for each of its frames.");
            takes[t].coefficients.push_back(valuesAt(given[k], takes[t].warp.positions));
        }
    }
}

} // namespace

Movement makeMovement(std::span<const TrainingTake> takes, std::size_t reference, const BodyParts& parts,
                      const std::vector<MovementBlend>& blends, const MovementSettings& settings,
                      Positions templatePose, const Progress& progress)
{
    checkBlends(blends, takes.size());
    // Limbs that swing do not turn the body against the template.
    AlignmentSettings alignment = settings.alignment;
    if (alignment.anchor.empty())
        alignment.anchor = anchorVertices(parts);
    constexpr double aligning = 0.5;
    Movement movement{.topology = takes.empty() ? nullptr : takes.front().sequence.topology,
                      .parts = parts,
                      .alignment = alignTakes(takes, reference, alignment, templatePose,
                                              progress.part(0, blends.empty() ? 1 : aligning)),
                      .blends = blends,
                      .preblends = preblendsOf(blends),
                      .training = {}};
    alignCoefficients(takes, settings.coefficients.size(), movement.alignment.takes);
    if (!movement.preblends.empty())
        addPreblends(movement, settings, progress.part(aligning, 1));
    for (const BodyPart& part : parts.parts)
        movement.training.push_back(
            partTraining(movement.alignment.takes, part, settings.displacementShare, settings.coefficients));
    return movement;
}

std::vector<GpdmLearning> learnParts(const Movement& movement, const GpdmSettings& settings,
                                     const Progress& progress, const PartWatch& watch)
{
    const std::size_t count = movement.training.size();
    std::vector<GpdmLearning> learned(count);
    std::vector<std::atomic<double>> fractions(count);
    std::mutex mutex;
    const auto reportAll = [&] {
        double sum = 0;
        for (const auto& fraction : fractions)
            sum += fraction;
        // Learning answers a cancellation by itself.
        if (!progress.isCancelled())
            progress.report(sum / static_cast<double>(count));
    };
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t p) {
        const Progress own(progress.token(), [&, p](double fraction) {
            fractions[p] = fraction;
            reportAll();
        });
        const PartTraining& training = movement.training[p];
        learned[p] = learnGpdm(training.rows, training.spans, settings, own,
                               [&, p](int iteration, double objective, const GpdmState& state) {
                                   if (!watch)
                                       return;
                                   const std::scoped_lock lock(mutex);
                                   watch(p, iteration, objective, state);
                               });
    });
    return learned;
}

} // namespace quadrille
