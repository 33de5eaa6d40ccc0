// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/sequence/topology.h"
#include "model/transfer/bodyplaces.h"

#include <array>
#include <vector>

namespace quadrille {

/// Which way the lower arms and legs of a humanoid, and its feet, point in each of its poses. Immutable.
class LimbDirections
{
public:
    /// Lower arms, left and right, lower legs, and feet.
    static constexpr std::size_t limbs = 6;
    using Directions = std::array<Vec3d, limbs>;

    /// \param mesh  the one of the places.
    LimbDirections(const BodyPlaces& places, const Topology& mesh);

    /// For each part the unit vector along which it leads from its end to the body, by least squares over its
    /// surface; zero where it has none. \param pose  all vertices. Cost: O(triangles).
    Directions of(Positions pose) const;

private:
    struct Place
    {
        Triangle triangle;
        double along = 0; ///< how far from the limb's end, any unit
    };
    std::array<std::vector<Place>, limbs> m_places;
};

/// By how much limbs of one body miss the directions that those of another have, radians; not a number where
/// none is known.
struct LimbErrors
{
    double limbs = 0; ///< mean over lower arms and legs
    double feet = 0;  ///< mean over the feet
};
LimbErrors limbErrors(const LimbDirections::Directions& made, const LimbDirections::Directions& wanted);

} // namespace quadrille
