// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/transfer/transferclip.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// What of a body a place belongs to.
enum class BodyRegion
{
    Trunk,
    Head,
    LeftUpperArm,
    LeftLowerArm, ///< and the hand
    RightUpperArm,
    RightLowerArm,
    LeftThigh,
    LeftShin, ///< and the foot
    RightThigh,
    RightShin,
};
inline constexpr std::size_t bodyRegions = 10;

/// Where the triangles of a humanoid lie on it, whatever its pose and proportions: by how far each is, over
/// the surface, on its ways between hands, feet and head, and by where the surface faces. Immutable; safe
/// from any thread.
class BodyPlaces
{
public:
    /// \param mesh  arms and legs that do not touch each other, feet on the ground. \param withoutLimbs  what
    /// is thrown for other meshes: TransferNoLimbsOfTemplate or …OfTarget. \throws Error that, as
    /// SolidTarget, Cancelled. Cost: five surface distances.
    BodyPlaces(const PosedMesh& mesh, UpAxis up, ErrorCode withoutLimbs, const Progress& progress = {});

    std::size_t size() const { return m_places.size(); }
    /// Whether it is told where the triangle is: it has an area, and hangs on the body.
    bool knows(TriangleIndex triangle) const { return m_places[triangle.value].isUsable; }
    /// \pre knows(triangle).
    BodyRegion regionOf(TriangleIndex triangle) const { return m_places[triangle.value].region; }
    /// How far over the surface it is from the hand, foot or head that is nearest, of the body's length.
    /// \pre knows(triangle).
    double fromEnd(TriangleIndex triangle) const
    {
        return static_cast<double>(m_places[triangle.value].fromEnd);
    }
    /// What tells a place: how far it is on its ways between landmarks, and from hands and feet, shares of
    /// the body's length; where the place faces at the end, as the body stands. Those of one place of two
    /// bodies differ by about 0.1. \pre knows(triangle).
    using Values = Eigen::Matrix<float, 13, 1>;
    static constexpr Eigen::Index poseFreeValues = 10; ///< that no pose changes, at the front
    const Values& values(TriangleIndex triangle) const { return m_places[triangle.value].values; }
    /// The triangle at the same place on the other side of the body. \pre knows(triangle).
    /// Cost: O(triangles).
    std::optional<TriangleIndex> mirrored(TriangleIndex triangle) const;

private:
    struct Place
    {
        Values values = Values::Zero();
        BodyRegion region = BodyRegion::Trunk;
        float fromEnd = 0;
        bool isUsable = false;
    };

    std::optional<TriangleIndex> nearest(const Values& values) const;

    std::vector<Place> m_places; ///< one for each triangle
};

/// The pair on the other side of both bodies; nothing where one of its triangles is at no known place, or the
/// pair lies in the middle and mirrors onto itself.
std::optional<TrianglePair> mirroredPair(const TrianglePair& pair, const BodyPlaces& onTemplate,
                                         const BodyPlaces& onTarget);

/// Some pairs, and behind them those of the other side whose triangles have none. Cost: O(pairs · triangles).
/// \throws Error Cancelled.
std::vector<TrianglePair> withMirroredPairs(std::vector<TrianglePair> pairs, const BodyPlaces& onTemplate,
                                            const BodyPlaces& onTarget, const Progress& progress = {});

/// Parts of a template that no pair holds: how they turn is guessed from their neighbours.
std::vector<BodyRegion> regionsWithoutPairs(std::span<const TrianglePair> pairs,
                                            const BodyPlaces& onTemplate);

} // namespace quadrille
