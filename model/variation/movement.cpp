// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/movement.h"

#include "model/core/badargument.h"
#include "model/variation/preblend.h"

#include <array>
#include <atomic>
#include <charconv>
#include <mutex>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

void checkBlend(const MovementBlend& blend, std::size_t takes)
{
    if (blend.from >= takes || blend.to >= takes || blend.from == blend.to)
        refuse("A blend is not between two different takes", "Name two of the takes that are learned.");
    double before = 0;
    for (const double weight : blend.weights) {
        if (!(weight > before && weight < 1))
            refuse("The weights of a blend are not ascending between 0 and 1",
                   "Write weights like [0.25, 0.5, 0.75].");
        before = weight;
    }
}

std::string toText(double number)
{
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

} // namespace

std::size_t Movement::blendedTake(std::size_t blend, std::size_t weight) const
{
    std::size_t index = capturedCount() + weight;
    for (std::size_t b = 0; b < blend; ++b)
        index += blends[b].weights.size();
    return index;
}

std::string blendName(const std::string& from, const std::string& to, double weight)
{
    return from + "–" + to + " " + toText(weight);
}

Movement makeMovement(std::span<const TrainingTake> takes, std::size_t reference, const BodyParts& parts,
                      const std::vector<MovementBlend>& blends, const MovementSettings& settings,
                      Positions templatePose, const Progress& progress)
{
    for (const MovementBlend& blend : blends)
        checkBlend(blend, takes.size());
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
                      .training = {}};
    std::vector<AlignedTake>& all = movement.alignment.takes;
    if (!blends.empty()) {
        const auto system = std::make_shared<const PoissonSystem>(movement.topology);
        double done = 0;
        std::size_t count = 0;
        for (const MovementBlend& blend : blends)
            count += blend.weights.size();
        for (const MovementBlend& blend : blends) {
            for (const double weight : blend.weights) {
                const double share = (1 - aligning) / static_cast<double>(count);
                const Progress own = progress.part(aligning + done * share, aligning + (done + 1) * share);
                const AlignedTake& from = all[blend.from];
                const AlignedTake& to = all[blend.to];
                all.push_back(blendedTake(system, from, to, weight, blendName(from.name, to.name, weight),
                                          {.up = settings.alignment.up, .method = settings.interpolation},
                                          own));
                ++done;
            }
        }
    }
    for (const BodyPart& part : parts.parts)
        movement.training.push_back(partTraining(all, part, settings.displacementShare));
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
