// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/symmetry.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/finishing/loop.h"

namespace quadrille {

/// The vertical plane across which a clip is mirrored, seen from above.
struct MirrorLine
{
    Vec2d point = Vec2d::Zero();
    Vec2d direction = Vec2d::UnitX(); ///< of length 1

    Vec2d reflected(const Vec2d& p) const;
};

/// Through the centre of the first frame along the way from there to the last one; where the clip goes less
/// than a quarter of the figure's height, along the symmetry plane of the first pose, so that it goes on
/// facing where it did.
/// \pre The clip has a frame, and the vertices of the symmetry.
MirrorLine mirrorLine(const Clip& clip, const Symmetry& symmetry, UpAxis up);

/// The clip with left and right exchanged: each vertex moves as its counterpart did on the other side of the
/// plane. Twice is the clip itself where the symmetry is exact. Contacts and labels follow from the origins,
/// which say that they are mirrored; textures stay as they are.
/// \throws Error VertexCountMismatch, Cancelled.
Clip mirrored(const Clip& clip, const Symmetry& symmetry, const MirrorLine& line, UpAxis up,
              const Progress& progress = {});
GroundMotion mirrored(const GroundMotion& motion, const MirrorLine& line);
Loop mirrored(const Loop& loop, const Symmetry& symmetry, const MirrorLine& line, UpAxis up,
              const Progress& progress = {});

} // namespace quadrille
