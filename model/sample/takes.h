// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/random.h"
#include "model/sample/posture.h"
#include "model/sequence/meshsequence.h"

#include <string>
#include <vector>

namespace quadrille {

constexpr double sampleFps = 25;

/// What is performed in a take, before a body is put on it.
struct TakeMotion
{
    std::string kind; ///< "walk", "long jump", …
    std::vector<Posture> frames;
    std::vector<LabelSpan> labels;
    /// Frames in the air with no foot on the ground; empty for most kinds.
    FrameRange flight;
};

/// The kinds of takes, in the order in which they are listed.
const std::vector<std::string>& takeKinds();

/// One performance; each seed of `random` differs in timing, size and style.
/// \param variant zero-based number of the take within its kind.
TakeMotion performTake(const Skeleton& skeleton, const std::string& kind, int variant, Random& random);

TakeMotion performGait(const Skeleton& skeleton, const std::string& kind, int variant, Random& random);
TakeMotion performJump(const Skeleton& skeleton, const std::string& kind, Random& random);
TakeMotion performReach(const Skeleton& skeleton, bool high, int variant, Random& random);
TakeMotion performKick(const Skeleton& skeleton, Random& random);
TakeMotion performIdle(const Skeleton& skeleton, int variant, Random& random);
TakeMotion performDance(const Skeleton& skeleton, int variant, Random& random);

/// Samples keys at the sample's rate.
std::vector<Posture> framesOf(const std::vector<PostureKey>& keys, double duration);

/// Spans in which each foot stands: it bears on the ground and does not move.
std::vector<ContactSpan> contactsOf(const TakeMotion& take);

} // namespace quadrille
