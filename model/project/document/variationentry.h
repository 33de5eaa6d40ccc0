// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/animationentry.h"
#include "model/variation/gpdm/gpdm.h"
#include "model/variation/gpdm/hmc.h"
#include "model/variation/parts/bodyparts.h"
#include "model/variation/posedraw.h"
#include "model/variation/trajectorylimits.h"
#include "model/variation/variationlimits.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A curve on the mesh of a character that bounds parts of its body.
struct PartCurveEntry
{
    PartCurve curve;
    /// The vertices that the user chose, in order; the others lie on the way between them. May be empty.
    std::vector<VertexIndex> points;
    UnknownKeys unknown;

    bool operator==(const PartCurveEntry&) const = default;
};

struct PartEntry
{
    PartDescription part;
    UnknownKeys unknown;

    bool operator==(const PartEntry&) const = default;
};

/// The parts that the body of one character is cut into.
struct BodyPartsEntry
{
    std::string character;          ///< may be left out in a file with one character
    std::optional<NamedFrame> pose; ///< in which curves are drawn; the first frame of its first sequence
    std::vector<PartCurveEntry> curves;
    std::vector<PartEntry> parts; ///< without any, the whole body is one
    UnknownKeys unknown;

    bool operator==(const BodyPartsEntry&) const = default;
};

/// A take that variations are learned from.
struct TrainingEntry
{
    std::string sequence;
    std::optional<FrameRange> range; ///< its whole, or the cycle that is found
    UnknownKeys unknown;

    bool operator==(const TrainingEntry&) const = default;
};

/// The other two takes of a blend of four, which lie at the corners of a square.
struct AcrossBlendEntry
{
    std::string from;                 ///< across from BlendEntry::from
    std::string to;                   ///< across from BlendEntry::to
    std::vector<double> weights{0.5}; ///< of this pair against the first one; between 0 and 1, ascending
    UnknownKeys unknown;

    bool operator==(const AcrossBlendEntry&) const = default;
};

/// Two takes that are blended before learning (CVS §7), or four.
struct BlendEntry
{
    std::string from;                 ///< w = 0
    std::string to;                   ///< w = 1
    std::vector<double> weights{0.5}; ///< of the blends that are learned, too; between 0 and 1, ascending
    /// Then all nodes of the grid over the square are learned, its edges included.
    std::optional<AcrossBlendEntry> across;
    UnknownKeys unknown;

    bool operator==(const BlendEntry&) const = default;
};

/// The other two takes of a blend of four.
struct AcrossSamplesEntry
{
    std::string of;    ///< across from SamplesEntry::of
    std::string to;    ///< across from SamplesEntry::to
    double weight = 0; ///< of this pair against the first one, 0 … 1
    UnknownKeys unknown;

    bool operator==(const AcrossSamplesEntry&) const = default;
};

/// Variations that are drawn of one take, or of a blend of two or four.
struct SamplesEntry
{
    std::string of;                           ///< a take; the first of two where `to` names another
    std::string to;                           ///< the second of a blend; empty for one take
    double weight = 0;                        ///< of the second, 0 … 1; of both seconds of four
    std::optional<AcrossSamplesEntry> across; ///< only with `to`
    int count = 5;
    std::uint64_t seed = 1;
    std::vector<int> discarded; ///< which of the set were thrown away, from 1
    UnknownKeys unknown;

    bool operator==(const SamplesEntry&) const = default;
};

/// Variations of some takes of one kind of movement: what is learned, and what is drawn.
struct VariationEntry
{
    std::string name;
    std::string character; ///< may be left out in a file with one character
    std::vector<TrainingEntry> training;
    std::string reference; ///< the take whose timing the others are warped to; the first when empty
    std::optional<NamedFrame> templatePose; ///< that all frames are laid onto; the reference's first frame
    bool cycles = true;                     ///< takes of locomotion are cut to one cycle, where there is one
    std::vector<BlendEntry> blends;
    double displacementShare = 6; ///< variance of the displacements, in mean variances of a coordinate
    GpdmSettings learning;
    HmcSettings chain;
    TrajectoryLimits extent;
    std::vector<SamplesEntry> samples;
    PoseDraw draw = PoseDraw::Mean;
    bool correctsContacts = true; ///< feet that stand in the take stand still
    VariationLimits limits;       ///< beyond which a variation is rejected
    UnknownKeys unknownOfLearning;
    UnknownKeys unknownOfSampling;
    UnknownKeys unknownOfLimits;
    UnknownKeys unknown;

    bool operator==(const VariationEntry&) const = default;
};

} // namespace quadrille
