// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <string>
#include <vector>

namespace quadrille {

/// Positions with y up: frames × vertices.
struct UprightFrames
{
    std::vector<Vec3f> positions;
    std::size_t vertices = 0;
    double fps = 0; ///< 0: unknown

    std::size_t count() const { return vertices == 0 ? 0 : positions.size() / vertices; }
    Positions at(std::size_t frame) const { return Positions(positions).subspan(frame * vertices, vertices); }
};

UprightFrames upright(std::vector<Vec3f> positions, std::size_t vertices, UpAxis up);
/// \throws Error as loadFrames.
UprightFrames loadUpright(const MeshSequence& sequence, UpAxis up, const Progress& progress);

/// Vertices are zero-based and ascending.
struct Foot
{
    std::string name; ///< "left", "right", or "foot 1", "foot 2", … where there are not two
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> ankle; ///< the ring of vertices above
};

/// Who stands in some frames, and on what.
struct Figure
{
    float ground = 0;        ///< height of most frames' lowest points, metres
    float height = 0;        ///< metres
    std::size_t tallest = 0; ///< the frame in which the figure stands tallest on more than one leg
    std::vector<Foot> feet;  ///< empty where it stands on one piece
};

/// \param footShare  how high feet reach, from below, body heights.
Figure findFigure(const Topology& topology, const UprightFrames& frames, double footShare);

/// The legs of a figure, by its feet.
struct Legs
{
    std::vector<Foot> feet; ///< empty where the figure stands on one piece
    /// Of each foot the vertices of its leg, ascending: what hangs together with the foot below the highest
    /// level at which no other foot does, at most 0.6 body heights.
    std::vector<std::vector<std::uint32_t>> vertices;
    double height = 0;            ///< of the figure, metres
    std::vector<Vec3f> reference; ///< the pose in which it stands tallest, y up
};

/// \param footShare  as for findFigure.
Legs findLegs(const Topology& topology, const UprightFrames& frames, double footShare);

/// Mean of some vertices; the origin when there are none.
Vec3f meanOf(Positions positions, const std::vector<std::uint32_t>& of);

} // namespace quadrille
