// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/bodyalignment.h"

#include "model/transfer/pliablesurface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille {

namespace {

/// So many of the target's triangles are looked at while the template settles.
constexpr std::size_t lookedAt = 4000;
/// How often places look anew, and rounds of settling in between.
constexpr int placeLooks = 30;
constexpr int settlingRounds = 10;
/// What a place is held by, of the most that it can be; half of it where the triangle that it is nearest to
/// is so far from it, of the spread of the target.
constexpr double anchorShare = 1.0 / 15;
constexpr double halfWay = 0.2;
/// What the spread of the target is worth in a difference of places, at last, and two opposite normals.
constexpr double positionWeight = 1.3;
constexpr float laidNormalWeight = 0.25F;
/// A pair whose places differ so much is worth half.
constexpr double halfLikeness = 0.12;
/// A difference that no two known places have.
constexpr float unknown = 1e4F;

/// A column for each of some triangles.
using Values = Eigen::Matrix<float, BodyPlaces::Values::RowsAtCompileTime, Eigen::Dynamic>;

/// For each column of a matrix the nearest one of another.
template <class Matrix>
std::vector<Eigen::Index> nearestColumns(const Matrix& of, const Matrix& among)
{
    const Eigen::VectorXf squares = among.colwise().squaredNorm();
    const Eigen::MatrixXf products = -2 * among.transpose() * of;
    std::vector<Eigen::Index> nearest(static_cast<std::size_t>(of.cols()));
    for (std::size_t i = 0; i < nearest.size(); ++i)
        (products.col(static_cast<Eigen::Index>(i)) + squares).minCoeff(&nearest[i]);
    return nearest;
}

Values valuesOf(const BodyPlaces& places, const std::vector<TriangleIndex>& triangles)
{
    Values values(Values::RowsAtCompileTime, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i)
        values.col(static_cast<Eigen::Index>(i)) = places.values(triangles[i]);
    return values;
}

/// What places differ in that have been laid on each other.
class Comparison
{
public:
    /// \param spread  of the target. \param share  what positions are worth by now.
    Comparison(const Vec3d& middle, double spread, double share)
        : m_middle(middle), m_perMetre(positionWeight * std::sqrt(share) / spread)
    {
    }

    void fill(BodyFeatures& features, std::size_t column, const BodyPlaces::Values& values,
              const Vec3d& position, const Vec3d& normal) const
    {
        auto own = features.col(static_cast<Eigen::Index>(column));
        own.head<BodyPlaces::poseFreeValues>() = values.head<BodyPlaces::poseFreeValues>();
        own.segment<3>(BodyPlaces::poseFreeValues) = (m_perMetre * (position - m_middle)).cast<float>();
        own.tail<3>() = laidNormalWeight * normal.cast<float>();
    }

private:
    Vec3d m_middle;
    double m_perMetre;
};

/// The target, turned as the template.
struct TurnedTarget
{
    Vec3d position(TriangleIndex t) const { return middleOf((*triangles)[t.value], pose); }
    Vec3d normal(TriangleIndex t) const { return normalOf((*triangles)[t.value], pose); }

    const std::vector<Triangle>* triangles = nullptr;
    std::vector<Vec3f> pose;
};

/// Known triangles of a mesh, evenly from its list; all where there are no more.
std::vector<TriangleIndex> someKnown(const BodyPlaces& places, std::size_t most)
{
    std::vector<TriangleIndex> known;
    for (std::size_t t = 0; t < places.size(); ++t) {
        if (places.knows(TriangleIndex(t)))
            known.emplace_back(t);
    }
    if (known.size() <= most)
        return known;
    std::vector<TriangleIndex> some;
    some.reserve(most);
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(known[i * known.size() / most]);
    return some;
}

std::optional<TriangleIndex> nearestTo(const BodyFeatures& of, TriangleIndex triangle,
                                       const BodyFeatures& among)
{
    const auto own = static_cast<Eigen::Index>(triangle.value);
    if (of(0, own) == unknown)
        return std::nullopt;
    Eigen::Index best = 0;
    (among.colwise() - of.col(own)).colwise().squaredNorm().minCoeff(&best);
    return among(0, best) == unknown ? std::nullopt
                                     : std::optional(TriangleIndex(static_cast<std::size_t>(best)));
}

/// A template while it is being laid onto a target.
class Laying
{
public:
    Laying(const PosedSurface& reference, const BodyPlaces& onReference, const PosedMesh& target,
           const BodyPlaces& onTarget, UpAxis up);

    /// Draws each place to the triangle that it is nearest to by now. \param share  what positions are worth,
    /// from 0, when it does not matter either how far that triangle is, to 1.
    void look(double share);

    const PliableSurface& laid() const { return m_laid; }
    const TurnedTarget& target() const { return m_target; }
    Comparison comparison(double share) const { return {m_spread.middle, m_spread.size, share}; }

private:
    PliableSurface m_laid;
    std::vector<TriangleIndex> m_sample; ///< of the target
    Values m_sampleValues;
    std::vector<std::size_t> m_places; ///< of the template, that are known
    Values m_values;
    TurnedTarget m_target;
    Spread m_spread; ///< of the target
};

Laying::Laying(const PosedSurface& reference, const BodyPlaces& onReference, const PosedMesh& target,
               const BodyPlaces& onTarget, UpAxis up)
    : m_laid(reference, {})
    , m_sample(someKnown(onTarget, lookedAt))
    , m_sampleValues(valuesOf(onTarget, m_sample))
{
    std::vector<TriangleIndex> triangles;
    for (std::size_t i = 0; i < m_laid.size(); ++i) {
        if (!onReference.knows(m_laid.triangle(i)))
            continue;
        m_places.push_back(i);
        triangles.push_back(m_laid.triangle(i));
    }
    m_values = valuesOf(onReference, triangles);
    // How the two are turned and of what size they are is told by what is alike before anything is laid.
    std::vector<TrianglePair> pairs;
    const std::vector<Eigen::Index> alike = nearestColumns(m_values, m_sampleValues);
    for (std::size_t i = 0; i < m_places.size(); ++i)
        pairs.push_back({triangles[i], m_sample[static_cast<std::size_t>(alike[i])]});
    const double angle = turnOntoTemplate(reference.mesh(), target, pairs, up);
    m_target = {&target.topology->triangles(), turned(target.positions, angle, up)};
    std::vector<Vec3d> from;
    std::vector<Vec3d> onto;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        from.push_back(m_laid.position(m_places[i]));
        onto.push_back(m_target.position(pairs[i].onTarget));
    }
    m_spread = spreadOf(onto);
    m_laid.scale(m_spread.size / spreadOf(from).size);
}

void Laying::look(double share)
{
    const Comparison now = comparison(share);
    BodyFeatures places(BodyFeatures::RowsAtCompileTime, m_values.cols());
    for (std::size_t i = 0; i < m_places.size(); ++i)
        now.fill(places, i, m_values.col(static_cast<Eigen::Index>(i)), m_laid.position(m_places[i]),
                 m_laid.normal(m_places[i]));
    BodyFeatures sample(BodyFeatures::RowsAtCompileTime, m_sampleValues.cols());
    for (std::size_t s = 0; s < m_sample.size(); ++s)
        now.fill(sample, s, m_sampleValues.col(static_cast<Eigen::Index>(s)), m_target.position(m_sample[s]),
                 m_target.normal(m_sample[s]));
    const std::vector<Eigen::Index> nearest = nearestColumns(places, sample);
    std::vector<PliableSurface::Anchor> anchors;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const TriangleIndex onto = m_sample[static_cast<std::size_t>(nearest[i])];
        const Vec3d position = m_target.position(onto);
        const double nearness =
            share > 0 ? m_laid.nearness(m_places[i], position, halfWay * m_spread.size) : 1;
        anchors.push_back({m_places[i], position, m_target.normal(onto), anchorShare * nearness});
    }
    m_laid.settle(anchors, settlingRounds);
}

} // namespace

BodyAlignment::BodyAlignment(const PosedMesh& reference, const BodyPlaces& onReference,
                             const PosedMesh& target, const BodyPlaces& onTarget, UpAxis up,
                             const Progress& progress)
{
    const PosedSurface surface(reference);
    Laying laying(surface, onReference, target, onTarget, up);
    for (int look = 0; look < placeLooks; ++look) {
        progress.report(look, placeLooks);
        laying.look(static_cast<double>(look) / (placeLooks - 1));
    }
    const PliableSurface& laid = laying.laid();
    const Comparison comparison = laying.comparison(1);
    const std::vector<Triangle>& triangles = reference.topology->triangles();
    const std::vector<std::optional<std::size_t>> nearestPlaces = laid.nearestPlaces(surface);
    m_ofTemplate.setConstant(BodyFeatures::RowsAtCompileTime, static_cast<Eigen::Index>(triangles.size()),
                             unknown);
    m_turns.assign(triangles.size(), Eigen::Matrix3f::Identity());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!nearestPlaces[t] || !onReference.knows(TriangleIndex(t)))
            continue;
        const std::size_t place = *nearestPlaces[t];
        m_turns[t] = laid.turn(place).cast<float>();
        comparison.fill(m_ofTemplate, t, onReference.values(TriangleIndex(t)),
                        laid.moved(place, middleOf(triangles[t], reference.positions)),
                        laid.turn(place) * normalOf(triangles[t], reference.positions));
    }
    m_ofTarget.setConstant(BodyFeatures::RowsAtCompileTime, static_cast<Eigen::Index>(onTarget.size()),
                           unknown);
    for (std::size_t t = 0; t < onTarget.size(); ++t) {
        const TriangleIndex triangle(t);
        if (onTarget.knows(triangle))
            comparison.fill(m_ofTarget, t, onTarget.values(triangle), laying.target().position(triangle),
                            laying.target().normal(triangle));
    }
    progress.report(1);
}

std::optional<TriangleIndex> BodyAlignment::onTarget(TriangleIndex ofTemplate) const
{
    return nearestTo(m_ofTemplate, ofTemplate, m_ofTarget);
}

std::optional<TriangleIndex> BodyAlignment::onTemplate(TriangleIndex ofTarget) const
{
    return nearestTo(m_ofTarget, ofTarget, m_ofTemplate);
}

double BodyAlignment::likeness(const TrianglePair& pair) const
{
    const auto from = m_ofTemplate.col(static_cast<Eigen::Index>(pair.onTemplate.value));
    const auto onto = m_ofTarget.col(static_cast<Eigen::Index>(pair.onTarget.value));
    if (from[0] == unknown || onto[0] == unknown)
        return std::numeric_limits<double>::quiet_NaN();
    const double difference = static_cast<double>((from - onto).norm()) / halfLikeness;
    return 1 / (1 + difference * difference);
}

} // namespace quadrille
