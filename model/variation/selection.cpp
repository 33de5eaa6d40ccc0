// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/selection.h"

#include "model/core/random.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

struct Made
{
    Clip clip;
    Candidate candidate;
};

} // namespace

int candidatesFor(int count)
{
    return count == 0 ? 0 : 4 * count + 4;
}

VariationSelection selectVariations(const LearnedMovement& learned, const VariationSubject& subject,
                                    const std::vector<LatentVariation>& latents, int count,
                                    std::uint64_t seed, const VariationPoses& settings,
                                    const VariationMeter& meter, const FrameLayout& layout,
                                    const VariationLimits& limits, const Progress& progress)
{
    VariationSelection selection;
    const auto wanted = static_cast<std::size_t>(std::max(count, 0));
    while (selection.accepted.size() < wanted && selection.candidates.size() < latents.size()) {
        // No more than are still needed, so that none is made in vain but the rejected ones.
        const std::size_t first = selection.candidates.size();
        const std::size_t round = std::min(wanted - selection.accepted.size(), latents.size() - first);
        std::vector<Made> made(round);
        tbb::parallel_for(std::size_t{0}, round, [&](std::size_t i) {
            const Progress own(progress.token());
            VariationPoses poses = settings;
            poses.seed = streamSeed(seed, first + i);
            made[i].clip = makeVariation(learned, subject, latents[first + i], layout, poses, own);
            made[i].candidate.quality = meter.measure(made[i].clip, own);
            made[i].candidate.faults = judge(made[i].candidate.quality, limits);
        });
        for (Made& each : made) {
            if (each.candidate.faults.empty()) {
                selection.accepted.push_back(static_cast<int>(selection.candidates.size()));
                selection.clips.push_back(std::move(each.clip));
                each.candidate.number = static_cast<int>(selection.accepted.size());
            }
            selection.candidates.push_back(std::move(each.candidate));
        }
        progress.report(static_cast<std::int64_t>(selection.accepted.size()), count);
    }
    return selection;
}

} // namespace quadrille
