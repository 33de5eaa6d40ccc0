// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/limbdirections.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace quadrille {

namespace {

/// Which places tell the direction of a part: where it is straight, away from joints. Upper arms and thighs
/// are too short for their width.
struct Part
{
    BodyRegion region;
    double from; ///< how far from the limb's end, of the body's length; so for `to`
    double to;
};
constexpr std::array<Part, LimbDirections::limbs> parts{{{BodyRegion::LeftLowerArm, 0.08, 0.25},
                                                         {BodyRegion::RightLowerArm, 0.08, 0.25},
                                                         {BodyRegion::LeftShin, 0.17, 0.36},
                                                         {BodyRegion::RightShin, 0.17, 0.36},
                                                         {BodyRegion::LeftShin, 0, 0.1},
                                                         {BodyRegion::RightShin, 0, 0.1}}};
constexpr std::size_t feet = 4; ///< the first foot

/// Mean angle of those directions, from one to before another, that both have.
double meanAngle(const LimbDirections::Directions& made, const LimbDirections::Directions& wanted,
                 std::size_t first, std::size_t end)
{
    double sum = 0;
    double count = 0;
    for (std::size_t i = first; i < end; ++i) {
        if (made[i].isZero() || wanted[i].isZero())
            continue;
        sum += std::atan2(made[i].cross(wanted[i]).norm(), made[i].dot(wanted[i]));
        ++count;
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

LimbDirections::LimbDirections(const BodyPlaces& places, const Topology& mesh)
{
    for (std::size_t t = 0; t < places.size(); ++t) {
        if (!places.knows(TriangleIndex(t)))
            continue;
        const double along = places.fromEnd(TriangleIndex(t));
        for (std::size_t p = 0; p < limbs; ++p) {
            if (parts[p].region == places.regionOf(TriangleIndex(t)) && parts[p].from <= along &&
                along < parts[p].to)
                m_places[p].push_back({mesh.triangles()[t], along});
        }
    }
}

LimbDirections::Directions LimbDirections::of(Positions pose) const
{
    Directions directions;
    for (std::size_t limb = 0; limb < limbs; ++limb) {
        double area = 0;
        double along = 0;
        Vec3d middle = Vec3d::Zero();
        Vec3d product = Vec3d::Zero();
        for (const Place& place : m_places[limb]) {
            const auto corner = [&](std::size_t c) -> Vec3d {
                return pose[place.triangle[c].value].cast<double>();
            };
            const double weight = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
            const Vec3d p = middleOf(place.triangle, pose);
            area += weight;
            along += weight * place.along;
            middle += weight * p;
            product += weight * place.along * p;
        }
        directions[limb] = area > 0 ? Vec3d(product - along * middle / area) : Vec3d::Zero();
        const double length = directions[limb].norm();
        directions[limb] = length > 0 ? Vec3d(directions[limb] / length) : Vec3d::Zero();
    }
    return directions;
}

LimbErrors limbErrors(const LimbDirections::Directions& made, const LimbDirections::Directions& wanted)
{
    return {.limbs = meanAngle(made, wanted, 0, feet),
            .feet = meanAngle(made, wanted, feet, LimbDirections::limbs)};
}

} // namespace quadrille
