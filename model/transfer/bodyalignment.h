// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/transfer/bodyplaces.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace quadrille {

/// A column for each of some triangles: values of its place that no pose changes, where it is, how it faces.
using BodyFeatures = Eigen::Matrix<float, BodyPlaces::poseFreeValues + 6, Eigen::Dynamic>;

/// Where each triangle of a humanoid lies on another, whatever their poses and proportions: the template is
/// laid onto the target as rigidly as it can be (pliablesurface.h), each of its places drawn in turns to the
/// triangle of the target that is nearest to it by its ways to hands, feet and head, by where it has been
/// laid and by how it then faces. Immutable; safe from any thread.
class BodyAlignment
{
public:
    /// \param onReference, onTarget  places of the two. \throws Error Cancelled.
    /// Cost: that of PliableSurface and a fixed number of rounds over its places, O(triangles · log
    /// triangles).
    BodyAlignment(const PosedMesh& reference, const BodyPlaces& onReference, const PosedMesh& target,
                  const BodyPlaces& onTarget, UpAxis up, const Progress& progress = {});

    /// The triangle at the place of another body's; nothing where it is not known where that is.
    /// Cost: O(triangles); so for `onTemplate`.
    std::optional<TriangleIndex> onTarget(TriangleIndex ofTemplate) const;
    std::optional<TriangleIndex> onTemplate(TriangleIndex ofTarget) const;
    /// How alike two places are: 1 where nothing tells them apart; below about 0.3 a pair deserves a look;
    /// not a number where it is not known where one of them is.
    double likeness(const TrianglePair& pair) const;

    /// How what is about a triangle of the template turned when it was laid onto the target; not at all where
    /// its place is not known.
    const Eigen::Matrix3f& turn(TriangleIndex ofTemplate) const { return m_turns[ofTemplate.value]; }

private:
    // As much as each is worth; far from all others where a place is not known.
    BodyFeatures m_ofTemplate; ///< laid onto the target
    BodyFeatures m_ofTarget;
    std::vector<Eigen::Matrix3f> m_turns;
};

} // namespace quadrille
