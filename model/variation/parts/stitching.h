// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/variation/parts/bodyparts.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// How a child is laid onto its parent.
enum class ChildLaying
{
    Rigidly, ///< turned and moved (CVS §6); each part may be anywhere
    /// Moved alone: all parts have one frame of reference. Where the overlaps of two are turned against each
    /// other, as those of independent draws are by a few degrees, the turn goes over within the overlap
    /// instead of swinging the whole limb.
    Moved,
};

/// Joins parts of a body that were deformed one by one into one surface without seams (CVS §6): each child is
/// laid onto its parent over their overlap, cut from it along the closed curve on which both deviate
/// least, and merged with it by a Poisson solve. Around the curve the gradients go over from one to the other
/// within the overlap, so that no crease is left where the two differ. Factorised once for all frames;
/// immutable, safe from any thread.
class Stitching
{
public:
    /// \param pose  of all vertices, metres: gives the areas and the angles of the triangles.
    /// \param shapes  of all vertices: no triangle stretches or shrinks further than in these poses; without
    /// any, all stay as they are given.
    /// \pre The parts are those of the topology, as cutIntoParts makes them.
    Stitching(std::shared_ptr<const Topology> topology, BodyParts parts, Positions pose,
              std::span<const Positions> shapes = {}, ChildLaying laying = ChildLaying::Rigidly);
    ~Stitching();

    const Topology& topology() const;
    const BodyParts& parts() const { return m_parts; }

    /// Of each part the closed curve along which it is cut from its parent, in order; empty for the root.
    struct Seams
    {
        std::vector<std::vector<VertexIndex>> curves;

        bool operator==(const Seams&) const = default;
    };

    /// The curves that are best for all of some frames together, so that nothing jumps between them.
    /// \param parts  of each part frames × vertices, in BodyPart::vertices' order, metres; where
    /// the laying says. \return the same for any number of threads. \throws Error Cancelled. \pre All parts
    /// have as many frames.
    Seams bestSeams(std::span<const Positions> parts, const Progress& progress = {}) const;

    /// One frame. \param poses  of each part its vertices, in BodyPart::vertices' order, metres; where
    /// the laying says, the root gives the place. \param seams  of bestSeams. \param out  all vertices of the
    /// mesh, metres. \pre As many poses as parts.
    void stitch(std::span<const Positions> poses, const Seams& seams, MutablePositions out) const;

    /// One frame by itself, cut where that is best for it. \return where.
    Seams stitch(std::span<const Positions> poses, MutablePositions out) const;

private:
    struct Work;
    struct Frame;
    /// Of each part and edge of its overlap.
    using EdgeCosts = std::vector<std::vector<double>>;
    Seams cheapestSeams(const EdgeCosts& costs) const;

    BodyParts m_parts;
    ChildLaying m_laying;
    std::unique_ptr<const Work> m_work;
};

/// Frames of one movement, along the curves that are best for all of them, in parallel.
/// \param parts  of each part frames × vertices, metres, as for Stitching::bestSeams.
/// \return frames × vertices, metres; the same for any number of threads.
/// \throws Error Cancelled. \pre All parts have as many frames.
std::vector<Vec3f> stitchFrames(const Stitching& stitching, std::span<const Positions> parts,
                                const Progress& progress = {});

} // namespace quadrille
