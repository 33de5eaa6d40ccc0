// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/quality.h"
#include "model/variation/variations.h"

#include <cstdint>
#include <vector>

namespace quadrille {

/// How many latent variations are drawn at most so that so many of them are good.
int candidatesFor(int count);

/// A variation that was drawn and judged.
struct Candidate
{
    VariationQuality quality;
    std::vector<VariationFault> faults;
    int number = 0; ///< of the variation that it became, from 1; 0: rejected

    bool isAccepted() const { return number > 0; }
};

/// Variations that are good enough, and what was drawn for them.
struct VariationSelection
{
    std::vector<Candidate> candidates; ///< those that were judged, in their order
    std::vector<int> accepted;         ///< of each variation its candidate, from 0
    std::vector<Clip> clips;           ///< of the accepted ones, metres

    int rejectedCount() const { return static_cast<int>(candidates.size() - accepted.size()); }
};

/// Makes variations of drawn latents one after the other until enough of them are good; in parallel, with the
/// same result for any number of threads.
/// \param latents  candidates, perhaps more than are needed. \param seed  of the draws of poses.
/// \return fewer variations than `count` where too few candidates are good. \throws Error Cancelled.
VariationSelection selectVariations(const LearnedMovement& learned, const VariationSubject& subject,
                                    const std::vector<LatentVariation>& latents, int count,
                                    std::uint64_t seed, const VariationPoses& settings,
                                    const VariationMeter& meter, const FrameLayout& layout,
                                    const VariationLimits& limits = {}, const Progress& progress = {});

} // namespace quadrille
