// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/animationentry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille {

struct AnimationResult;

/// The keys of an animation, in the order of its constraints, which is that of their times.
std::vector<KeyEntry> keysOf(const AnimationEntry& animation);
/// Exchanges the keys for others, put into the order of their times; all other constraints stay where they
/// are, new keys come to the end.
void setKeys(AnimationEntry& animation, std::vector<KeyEntry> keys);
/// What is to be performed, in its order.
std::vector<ActionEntry> actionsOf(const AnimationEntry& animation);
/// Exchanges the actions for others, in this order; all other constraints stay where they are.
void setActions(AnimationEntry& animation, std::vector<ActionEntry> actions);

/// The time itself, or the next frame after it that no key stands at: no two keys have one time. Seconds.
/// Never before 0.
double freeKeyTime(const std::vector<KeyEntry>& keys, double time, double fps);

/// When the pose of each key is shown, output frames; empty where the result knows nothing of the key. Keys
/// are known by their poses: one that was moved since keeps its frame.
/// \param result  maybe of the animation as it was before its last edits; may be null.
std::vector<std::optional<std::int64_t>> obtainedFrames(const std::vector<KeyEntry>& keys,
                                                        const AnimationResult* result);

/// Output frames of each action, empty where the result knows nothing of it; as above. Actions are known by
/// all of their values.
std::vector<std::optional<FrameRange>> obtainedRanges(const std::vector<ActionEntry>& actions,
                                                      const AnimationResult* result);

} // namespace quadrille
