// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/core/table.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"
#include "model/transition/posedistancesettings.h"
#include "model/variation/timewarp.h"
#include "model/variation/training.h"

#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// Fewer frames than this are no movement that could be learned.
inline constexpr std::int64_t leastTrainingFrames = 4;

/// The vertices of the root that it shares with no other part: a body is laid onto another by its torso, so
/// that limbs swing beside it. None where the body is one part, or where too few are left.
std::vector<VertexIndex> anchorVertices(const BodyParts& parts);

/// A take that variations are learned from.
struct TrainingTake
{
    MeshSequence sequence;
    std::optional<FrameRange> range; ///< exactly these frames; its whole, or the cycle that is found
    /// Of each kind (MovementSettings::coefficients) all captured frames × values; may be empty.
    std::vector<RowMatrix> coefficients;
};

struct AlignmentSettings
{
    UpAxis up = UpAxis::Y;
    /// Vertices by which frames are laid onto the template: those of the root part. All when empty; then
    /// limbs that swing turn the whole body against the template, by up to a quarter turn in a wide stride.
    std::vector<VertexIndex> anchor;
    /// Takes of locomotion are cut to one cycle, where the reference has one.
    bool cycles = true;
    PoseDistanceSettings distance;
    /// Two people, or two ways of moving, differ in posture all the time, often by more than one of them
    /// changes within a step. So much of what a frame differs from all frames of the other take on average is
    /// taken off the cost of its matches: 0 … 1.
    double postureShare = 0.5;
    /// Cost of a match whose feet all differ in standing or not, in standard deviations of the costs.
    double contactWeight = 0.5;
    WarpSteps steps;
    /// Of warps, in reference frames (see warpOf).
    double smoothing = 1.5;
    /// A take is locomotion when its poses come back after a cycle: their mean distance then, in the largest
    /// after fewer frames. For the reference, and for takes beside a reference that is locomotion.
    double greatestReturn = 0.3;
    double greatestReturnBeside = 0.35;
    /// In a take that is no locomotion all over, a cycle that resembles the reference's is used when the mean
    /// distance of its matches is at most this share of the mean of all.
    double greatestMatch = 0.3;

    bool operator==(const AlignmentSettings&) const = default;
};

/// Which frames of a take are used, and why.
enum class TakeUse
{
    Given,    ///< the range that the user chose
    Cycle,    ///< one cycle of locomotion
    Whole,    ///< all: the reference is no locomotion, or cycles were not asked for
    TooShort, ///< all: it has no cycle, and fewer frames than one of the reference's
    NoCycle,  ///< all: it has frames enough, but no cycle like the reference's
};

/// How one take was warped: what a view of the warps shows.
struct WarpReport
{
    TakeUse use = TakeUse::Whole;
    /// What each match would cost: reference frames × frames of the take (of its range, or all, used or not),
    /// radians; shrunk by taking means where a side has more than 512.
    Table<float> costs;
    int rowsPerCell = 1;         ///< reference frames in a row of `costs`
    int columnsPerCell = 1;      ///< frames of the take in a column of `costs`
    FrameIndex firstColumn{0};   ///< frame of the take that the first column begins with
    std::vector<WarpMatch> path; ///< the reference's frames that are used from 0; the take's from its first
    double meanCost = 0;         ///< of a cell of the path
    /// Of each frame used: where between the first (0) and the last (1) reference frame it lies.
    std::vector<double> phases;
    /// Of the frames of the whole take: given, or found.
    std::vector<ContactSpan> contacts;
};

struct Alignment
{
    std::vector<AlignedTake> takes; ///< in the order of the training
    std::size_t reference = 0;
    std::vector<WarpReport> reports; ///< of each take
    /// That all frames are laid onto, moved so that the centroid of its anchor is the origin, metres.
    std::vector<Vec3f> templatePose;
    std::optional<std::int64_t> cycle; ///< frames of the reference's cycle, where it has one
    double fps = 25;                   ///< of the reference frames

    std::int64_t frameCount() const
    {
        return static_cast<std::int64_t>(takes.at(reference).placements.size());
    }
};

/// Finds cycles of locomotion, warps all takes onto the reference, and lays every frame onto the template.
/// Contacts that a take has not are found by detectContacts.
/// \param reference  whose timing the others are warped to. \param templatePose  of all vertices; empty: the
/// first frame of the reference that is used.
/// \throws Error TakeTooShort (fewer than leastTrainingFrames), RangeOutside, CharacterTopologyMismatch,
/// VertexCountMismatch (the template), IndexOutOfRange (the anchor), BadArgument (no takes, settings),
/// NoUsableTriangles, what reading frames throws, Cancelled. Cost: pose distances of the reference's frames
/// with all others.
Alignment alignTakes(std::span<const TrainingTake> takes, std::size_t reference,
                     const AlignmentSettings& settings = {}, Positions templatePose = {},
                     const Progress& progress = {});

} // namespace quadrille
