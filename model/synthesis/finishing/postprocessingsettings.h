// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"

#include <optional>
#include <variant>
#include <vector>

namespace quadrille {

/// How a clip is closed to a loop.
struct LoopSettings
{
    /// How far from the first frame the loop may begin, and how far from the last one it may end, seconds; a
    /// third of the clip when empty. The blend takes at least the shortest window of a transition from each.
    std::optional<Seconds> cutStart;
    std::optional<Seconds> cutEnd;
    /// The way over the ground, and the turn, of one cycle are taken out evenly: it stays where it is.
    bool inPlace = false;

    bool operator==(const LoopSettings&) const = default;
};

/// How slip is taken from feet that stand on the ground.
struct ContactCorrectionSettings
{
    /// Share of the slip that is taken out, in [0, 1].
    double strength = 1;
    /// How long before a contact the correction sets in and how long after it dies away, seconds.
    double easeSeconds = 0.2;
    /// How far a foot is moved at most, and how far it is turned about the vertical. What slips further keeps
    /// the rest of its slip.
    double greatestShift = 0.12; ///< heights of the figure
    double greatestTurn = 0.35;  ///< radians
    /// How far a foot is lifted or lowered at most, heights of the figure.
    double greatestLift = 0.02;

    bool operator==(const ContactCorrectionSettings&) const = default;
};

/// A point of a curve of time: when in the result which moment of the clip is shown.
struct RetimePoint
{
    Seconds output;
    Seconds clip;
    bool operator==(const RetimePoint&) const = default;
};

/// The result lasts so many times as long as the clip.
struct RetimeFactor
{
    double value = 1;
    bool operator==(const RetimeFactor&) const = default;
};

struct RetimeSettings
{
    /// Monotone through its points (PCHIP); output times rise, clip times do not fall. The first output time
    /// counts as the beginning of the result; both are measured from the first frame of the clip.
    using Curve = std::vector<RetimePoint>;
    /// A factor, how long the result lasts, or a curve. A clip lasts from its first frame to its last, a loop
    /// until its first frame comes again.
    std::variant<RetimeFactor, Seconds, Curve> time = RetimeFactor();
    /// The figure goes as fast over the ground as in the clip at the same pose (its feet then slide);
    /// otherwise it slows with its poses.
    bool keepsRootSpeed = false;

    bool operator==(const RetimeSettings&) const = default;
};

/// What is done to a clip once it is made. The steps follow each other as listed. The loop comes before the
/// contacts are corrected, for its blend lets feet slip too, and they are corrected all round it; both before
/// the way over the ground is taken out or the speed of the root is changed, for then feet slide on purpose.
/// Mirroring changes nothing of this. Times of the retiming are those of all repeats together.
struct PostProcessing
{
    std::optional<LoopSettings> loop;
    std::optional<ContactCorrectionSettings> contacts;
    bool mirror = false; ///< left and right
    int repeats = 1;     ///< of the loop, at least 1; needs a loop where it is more
    std::optional<RetimeSettings> retime;

    bool isEmpty() const { return *this == PostProcessing(); }
    bool operator==(const PostProcessing&) const = default;
};

} // namespace quadrille
