// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/bodyparts.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// Joins parts of a body that were deformed one by one into one surface without seams (CVS §6): each child is
/// laid rigidly onto its parent over their overlap, cut from it along the closed curve on which both deviate
/// least, and merged with it by a Poisson solve. Factorised once for all frames; immutable, safe from any
/// thread.
class Stitching
{
public:
    /// \param pose  of all vertices, metres: gives the areas and the angles of the triangles.
    Stitching(std::shared_ptr<const Topology> topology, BodyParts parts, Positions pose);
    ~Stitching();

    const BodyParts& parts() const { return m_parts; }

    /// One frame. \param poses  of each part its vertices, in BodyPart::vertices' order, metres; each part
    /// anywhere, the root gives the place. \param out  all vertices of the mesh, metres.
    /// \pre As many poses as parts.
    void stitch(std::span<const Positions> poses, MutablePositions out) const;

    /// The same with what was decided: of each part the closed curve that it was cut along.
    struct Seams
    {
        std::vector<std::vector<VertexIndex>> curves;
    };
    Seams stitchWithSeams(std::span<const Positions> poses, MutablePositions out) const;

private:
    struct Work;
    BodyParts m_parts;
    std::unique_ptr<const Work> m_work;
};

} // namespace quadrille
