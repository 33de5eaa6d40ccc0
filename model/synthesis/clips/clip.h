// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/transition/characterframes.h"

#include <vector>

namespace quadrille {

/// Where the pose of a frame comes from: a captured frame, or a point between two.
struct FrameProvenance
{
    NodeIndex source = 0;
    NodeIndex destination = 0; ///< equal to source for captured poses
    double lambda = 0;         ///< weight of the destination, 0 … 1
    bool mirrored = false;     ///< left and right exchanged
    /// Which variations of their takes the two show, in a list of names of whoever made the clip, from 1; 0:
    /// the frames as they were captured. A pose between a frame and its variation has that frame twice.
    std::int32_t sourceVariation = 0;
    std::int32_t destinationVariation = 0;

    /// Whether it shows one frame, or one variation of it.
    bool isSingle() const { return source == destination && sourceVariation == destinationVariation; }
    bool isCaptured() const { return isSingle() && sourceVariation == 0; }
    /// The captured frame that it is nearer to; its texture and its labels are those of the frame.
    NodeIndex nearest() const { return lambda < 0.5 ? source : destination; }
    /// How much of the pose is of variations, 0 … 1.
    double variedShare() const
    {
        return (sourceVariation != 0 ? 1 - lambda : 0) + (destinationVariation != 0 ? lambda : 0);
    }
    bool operator==(const FrameProvenance&) const = default;
};

/// A mesh sequence that was made from captured ones, with the origin of each of its frames: a plain value,
/// whatever made it.
struct Clip
{
    std::shared_ptr<const Topology> topology;
    double fps = 25;
    std::vector<Vec3f> positions;         ///< frames × vertices, metres
    std::vector<FrameProvenance> origins; ///< of each frame
    /// Where the texture of each frame comes from; none: from its origin.
    std::vector<FrameProvenance> looks;

    std::int64_t frameCount() const { return static_cast<std::int64_t>(origins.size()); }
    Positions frame(std::int64_t frame) const;
    MutablePositions frame(std::int64_t frame);
};

/// The clip of a variation, whose origins count none, as one that shows it in all frames.
Clip shownAsVariation(Clip clip);

/// The clip as a sequence, which takes each frame's labels and contacts from its origin, and its texture from
/// its look: contacts are those of stancesOf, labels those of the nearer one. Frames of variations have the
/// texture of their pose where the textures' blender knows one. Where all origins' sequences have one
/// texture, or the same ones for each material, so has the clip; otherwise it has one for each frame (of the
/// first material). \param character  the frames that the origins count.
MeshSequence toSequence(std::string name, Clip clip, const CharacterFrames& character);
/// Its contacts alone.
std::vector<ContactSpan> contactsOf(const Clip& clip, const CharacterFrames& character);

} // namespace quadrille
