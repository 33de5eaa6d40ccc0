// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/mediacache.h"
#include "model/core/progress.h"
#include "model/core/units.h"
#include "model/sequence/framesource.h"
#include "model/sequence/texture.h"
#include "model/sequence/topology.h"

#include <memory>
#include <string>
#include <vector>

namespace quadrille {

/// A name for some frames of a sequence ("walk", "kick").
struct LabelSpan
{
    std::string label;
    FrameRange frames;
    bool operator==(const LabelSpan&) const = default;
};

/// A foot stands on the ground during these frames.
struct ContactSpan
{
    std::string foot; ///< "left", "right", or what the project calls it
    FrameRange frames;
    bool operator==(const ContactSpan&) const = default;
};

/// The positions of one frame; keeps them alive while it lives. Cheap to copy.
class Frame
{
public:
    Frame(Positions positions, std::shared_ptr<const void> owner)
        : m_positions(positions), m_owner(std::move(owner))
    {
    }
    Positions positions() const { return m_positions; }

private:
    Positions m_positions;
    std::shared_ptr<const void> m_owner;
};

/// Frames of one topology at one rate: a value that shares what is heavy. Positions are in the unit and
/// axes that it was opened for: those of the project, where it has one.
struct MeshSequence
{
    std::string name;
    std::shared_ptr<const Topology> topology;
    std::shared_ptr<const FrameSource> source;
    /// The frames of the source that belong to the sequence.
    FrameRange range;
    double fps = 25.0;
    TextureSet textures;
    /// Spans are in frames of the sequence, not of the source.
    std::vector<LabelSpan> labels;
    std::vector<ContactSpan> contacts;

    std::int64_t frameCount() const { return range.count(); }
    Seconds duration() const { return {static_cast<double>(frameCount()) / fps}; }
    FrameIndex sourceFrame(FrameIndex frame) const { return FrameIndex(range.first.value + frame.value); }

    /// Frame of the sequence, from memory, the cache or the source.
    /// \pre 0 ≤ frame < frameCount().
    /// \throws Error what the source throws, NonFiniteCoordinate.
    Frame frame(FrameIndex frame, MediaCache& cache = *MediaCache::shared()) const;
    /// The texture of a frame; null when there is none.
    std::shared_ptr<const Image> texture(FrameIndex frame, int material = 0,
                                         MediaCache& cache = *MediaCache::shared()) const;
    /// The same sequence cut to some of its frames; labels and contacts are cut along.
    /// \throws Error RangeOutside.
    MeshSequence cutTo(FrameRange frames) const;
};

/// A sequence over all frames of a source.
/// \throws Error VertexCountMismatch.
MeshSequence makeSequence(std::string name, std::shared_ptr<const Topology> topology,
                          std::shared_ptr<const FrameSource> source, double fps);

/// All frames in one array, frames × vertices, past the cache.
/// \throws Error as MeshSequence::frame, Cancelled.
std::vector<Vec3f> loadFrames(const MeshSequence& sequence, const Progress& progress = {});

/// The sequence at another rate, positions interpolated linearly in time; first and last frame stay,
/// textures, labels and contacts follow the nearest frame. Same rate: the sequence itself. \throws Error
/// BadArgument when fps is not positive and finite.
MeshSequence resampled(const MeshSequence& sequence, double fps);
/// How many frames come of so many at another rate. \param from, to  frames a second, positive.
std::int64_t resampledFrames(std::int64_t frames, double from, double to);

/// The sequence with every position multiplied by a matrix.
MeshSequence transformed(const MeshSequence& sequence, const Eigen::Matrix3f& matrix);

} // namespace quadrille
