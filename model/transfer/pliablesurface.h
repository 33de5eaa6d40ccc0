// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/transfer/posedsurface.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille {

/// How large a set of places is.
struct Spread
{
    Vec3d middle = Vec3d::Zero();
    double size = 0; ///< the root of their mean squared distance from there
};
/// Zero where there are none.
Spread spreadOf(std::span<const Vec3d> places);

/// Places spread over a surface that is laid onto another one: each is drawn to where it is held, and moves
/// with those near it over the surface as rigidly as it can. Source: Sorkine & Alexa, As-Rigid-As-Possible
/// Surface Modeling, 2007; that neighbours turn alike, Levi & Gotsman, Smooth Rotation Enhanced
/// As-Rigid-As-Possible Mesh Animation, 2015. Beyond both, what is near may grow or shrink: limbs of another
/// body are of other lengths.
class PliableSurface
{
public:
    /// Where a place is held.
    struct Anchor
    {
        std::size_t place = 0;
        Vec3d position; ///< metres
        Vec3d normal;   ///< unit length, or zero where it faces no way
        double share;   ///< of the weight that it has at most
    };

    /// \param surface  in the pose that the places start from. \param places  triangles that are places by
    /// all means; others, far from each other, follow until there are some hundreds.
    /// Cost: O(places · triangles), and for each place the surface distances to its neighbours.
    PliableSurface(const PosedSurface& surface, std::vector<TriangleIndex> places);

    std::size_t size() const { return m_triangles.size(); }
    TriangleIndex triangle(std::size_t place) const { return m_triangles[place]; }
    /// The place that is nearest to each triangle along edges; nothing for triangles without an area,
    /// and where no way leads. \param surface  the same. Cost: O(vertices · log vertices).
    std::vector<std::optional<std::size_t>> nearestPlaces(const PosedSurface& surface) const;

    /// All of it, about the origin, as if the mesh were of another size.
    void scale(double factor);
    /// Some rounds from where the places are. Cost: a factorisation of one row for each place; for each round
    /// a rotation for each place.
    void settle(std::span<const Anchor> anchors, int rounds);

    /// Where a place is now, metres, so for the next two.
    const Vec3d& position(std::size_t place) const { return m_positions[place]; }
    /// How it has turned since it started.
    const Eigen::Matrix3d& turn(std::size_t place) const { return m_turns[place]; }
    Vec3d normal(std::size_t place) const { return m_turns[place] * m_startNormals[place]; }
    /// One where a place is at a position, a half where it is `half` metres away, and less beyond.
    double nearness(std::size_t place, const Vec3d& position, double half) const;
    /// Where something beside a place is that started at a position of the mesh.
    Vec3d moved(std::size_t place, const Vec3d& start) const;

private:
    struct Near
    {
        std::size_t place = 0;
        double weight = 0;
    };
    /// What the surroundings of a place ask for.
    struct Fit
    {
        Eigen::Matrix3d turn;
        double growth = 1;
    };

    void choosePlaces(const PosedSurface& surface);
    void findNear(const PosedSurface& surface);
    Eigen::MatrixX3d pulls(std::span<const Anchor> anchors) const;
    std::optional<Fit> fit(std::size_t place, const Anchor* anchor) const;

    std::vector<TriangleIndex> m_triangles;
    std::vector<std::vector<Near>> m_near;
    std::vector<Vec3d> m_starts;
    std::vector<Vec3d> m_startNormals;
    double m_scale = 1; ///< of the starts against the mesh
    std::vector<Vec3d> m_positions;
    std::vector<Eigen::Matrix3d> m_turns;
    std::vector<double> m_growths;
};

} // namespace quadrille
