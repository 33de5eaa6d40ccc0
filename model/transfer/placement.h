// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// How a template moves over the ground while it performs, metres.
struct TemplateCourse
{
    std::vector<Vec3d> middles;       ///< of its marked triangles, in each frame
    std::vector<double> lowest;       ///< height of its lowest vertex, in each frame
    std::vector<std::uint8_t> stands; ///< 1 where a foot stands, by its contacts
    /// By how much what is lowest of it slides until the next frame; empty where it does not.
    std::vector<Vec3d> slides;
    double fps = 25;
    double ground = 0; ///< height at which feet rest, see groundOf
};

/// The middle one of the lowest points of frames in which a foot stands, else the lowest of all.
double groundOf(const TemplateCourse& course);

/// Poses of a target, one after the other: frames × vertices, metres.
struct PosedTarget
{
    std::span<Vec3f> positions;
    std::size_t vertices = 0;

    std::size_t count() const { return positions.size() / vertices; }
    std::span<Vec3f> at(std::size_t frame) const { return positions.subspan(frame * vertices, vertices); }
};

/// In which frames a foot stands, by the contacts of a sequence: 1, else 0.
std::vector<std::uint8_t> standingFrames(std::span<const ContactSpan> contacts, std::int64_t frames);

/// The mean way of the vertices that are lowest in both of two poses, up to 1.5 % of the height above the
/// lowest one; nothing where no vertex is.
std::optional<Vec3d> wayOfSoles(Positions before, Positions after, UpAxis up);

/// By how much the way of a template must be scaled so that a target's feet stand still where the template's
/// do, or slide as they do: least squares over the horizontal motion of what of the target is lowest from one
/// standing frame to the next. \param target  posed, the middles of its marks all at one place. \param usual
/// the ratio of the bodies' heights; returned where the template hardly moves over the ground while it
/// stands; what is found is within a quarter of it.
double scaleOfSteps(const TemplateCourse& course, const PosedTarget& target, UpAxis up, double usual);

/// By how much a pose of one frame must be moved: over the ground as the template from where it begins, by a
/// scale; up or down so that its lowest vertex is as high above the ground as the template's, by the scale.
/// \param pose  the middle of its marks at the origin.
Vec3d placeOf(const TemplateCourse& course, std::size_t frame, double scale, UpAxis up, Positions pose);

/// Moves each frame of a target so, with heights evened out over some hundredths of a second.
/// \param target  as for scaleOfSteps, the middles of its marks at the origin.
void placeOnGround(const TemplateCourse& course, double scale, UpAxis up, const PosedTarget& target);

} // namespace quadrille
