// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/parametric/parameters.h"

#include "model/core/badargument.h"
#include "model/geometry/procrustes.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace quadrille {

namespace {

Positions poseOf(const PerformedMovement& movement, std::size_t frame)
{
    return movement.poses.subspan(frame * movement.vertexCount, movement.vertexCount);
}

/// Steps from the first frame to the last, and to the first again where they are a cycle.
std::size_t stepCount(const PerformedMovement& movement)
{
    return movement.steps.size() - (movement.isCyclic ? 0 : 1);
}

double secondsOf(const PerformedMovement& movement)
{
    const auto end = movement.seconds.begin() + static_cast<std::ptrdiff_t>(stepCount(movement));
    return std::accumulate(movement.seconds.begin(), end, 0.0);
}

/// Along the circle on which the movement as a whole leads: bodies sway about their way.
double speedOf(const PerformedMovement& movement)
{
    GroundMotion whole;
    double way = 0;
    for (std::size_t f = 0; f < stepCount(movement); ++f) {
        whole = whole * movement.steps[f];
        way += movement.steps[f].shift.norm();
    }
    const double half = std::abs(whole.turn) / 2;
    constexpr double mostOfACircle = 2.5; // where a circle closes, its ends tell nothing of its length
    if (half < mostOfACircle)
        way = whole.shift.norm() * (half > 1e-6 ? half / std::sin(half) : 1);
    return way / secondsOf(movement);
}

double turningOf(const PerformedMovement& movement)
{
    double turn = 0;
    for (std::size_t f = 0; f < stepCount(movement); ++f)
        turn += movement.steps[f].turn;
    return turn * 180 / std::numbers::pi / secondsOf(movement);
}

double jumpHeightOf(const PerformedMovement& movement)
{
    const Eigen::Index up = Ground(movement.up).upAxis();
    double highest = 0;
    const double first = centroid(poseOf(movement, 0))[up];
    for (std::size_t f = 1; f < movement.steps.size(); ++f)
        highest = std::max(highest, centroid(poseOf(movement, f))[up] - first);
    return highest;
}

/// From the frame before the body leaves the ground to the one in which it is there again.
double jumpLengthOf(const PerformedMovement& movement)
{
    const Eigen::Index up = Ground(movement.up).upAxis();
    const auto less = [up](const Vec3f& a, const Vec3f& b) { return a[up] < b[up]; };
    std::vector<float> lowest;
    for (std::size_t f = 0; f < movement.steps.size(); ++f) {
        const Positions pose = poseOf(movement, f);
        lowest.push_back((*std::min_element(pose.begin(), pose.end(), less))[up]);
    }
    const Positions first = poseOf(movement, 0);
    const auto [feet, head] = std::minmax_element(first.begin(), first.end(), less);
    constexpr float share = 0.02F; // of the figure's height that counts as off the ground
    const float limit = *std::min_element(lowest.begin(), lowest.end()) + share * ((*head)[up] - (*feet)[up]);
    double longest = 0;
    GroundMotion flight;
    for (std::size_t f = 0; f < stepCount(movement); ++f) {
        const bool flies = lowest[f] > limit || lowest[(f + 1) % lowest.size()] > limit;
        flight = flies ? flight * movement.steps[f] : GroundMotion();
        longest = std::max(longest, flight.shift.norm());
    }
    return longest;
}

/// Where a vertex is when it is farthest from the centre of the body, seen from there; its height counts from
/// the ground.
Vec3d farthestOf(const PerformedMovement& movement, VertexIndex vertex)
{
    const Eigen::Index up = Ground(movement.up).upAxis();
    double farthest = -1;
    Vec3d place = Vec3d::Zero();
    for (std::size_t f = 0; f < movement.steps.size(); ++f) {
        const Positions pose = poseOf(movement, f);
        const Vec3d own = pose[vertex.value].cast<double>();
        Vec3d away = own - centroid(pose);
        if (away.norm() > farthest) {
            farthest = away.norm();
            away[up] = own[up];
            place = away;
        }
    }
    return place;
}

/// 1, p₀ …, then p₀², p₀·p₁ …
Eigen::RowVectorXd monomials(const SpacePoint& scaled, int dimension)
{
    const int count = 1 + dimension + dimension * (dimension + 1) / 2;
    Eigen::RowVectorXd row(count);
    row[0] = 1;
    int next = 1;
    for (int i = 0; i < dimension; ++i)
        row[next++] = scaled[static_cast<std::size_t>(i)];
    for (int i = 0; i < dimension; ++i) {
        for (int j = i; j < dimension; ++j)
            row[next++] = scaled[static_cast<std::size_t>(i)] * scaled[static_cast<std::size_t>(j)];
    }
    return row;
}

/// Places a twentieth of each range apart, as far as they lie in the space, and the takes' own.
std::vector<SpacePoint> samplePlaces(const WeightSpace& space)
{
    const auto [least, greatest] = space.range();
    constexpr int steps = 20;
    std::vector<SpacePoint> places;
    std::array<int, 3> counts{1, 1, 1};
    for (int d = 0; d < space.dimension(); ++d)
        counts[static_cast<std::size_t>(d)] = steps + 1;
    for (int i = 0; i < counts[0] * counts[1] * counts[2]; ++i) {
        const std::array<int, 3> at{i / (counts[1] * counts[2]), i / counts[2] % counts[1], i % counts[2]};
        SpacePoint place{};
        for (std::size_t d = 0; d < 3; ++d)
            place[d] = least[d] + (greatest[d] - least[d]) * at[d] / steps;
        const SpacePoint within = space.placeOf(space.at(place));
        double off = 0;
        for (std::size_t d = 0; d < 3; ++d) {
            if (greatest[d] > least[d])
                off = std::max(off, std::abs(within[d] - place[d]) / (greatest[d] - least[d]));
        }
        if (off < 1e-6)
            places.push_back(place);
    }
    for (std::size_t t = 0; t < space.takeCount(); ++t)
        places.push_back(space.nodes()[t].place);
    return places;
}

/// \throws Error BadArgument where a parameter does not follow its place along its axis.
void requireGrowth(const std::vector<SpacePoint>& places, const std::vector<SpacePoint>& values,
                   const std::vector<SpaceParameter>& parameters)
{
    for (std::size_t d = 0; d < parameters.size(); ++d) {
        double covariance = 0;
        double ofPlace = 0;
        double ofValue = 0;
        double meanPlace = 0;
        double meanValue = 0;
        const auto count = static_cast<double>(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            meanPlace += places[i][d] / count;
            meanValue += values[i][d] / count;
        }
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double place = places[i][d] - meanPlace;
            const double value = values[i][d] - meanValue;
            covariance += place * value;
            ofPlace += place * place;
            ofValue += value * value;
        }
        constexpr double leastCorrelation = 0.7;
        if (!(covariance > leastCorrelation * std::sqrt(ofPlace * ofValue)))
            refuse("The parameter “" + parameters[d].name +
                       "” of the blends of these takes does not grow with its place between them, so that it "
                       "cannot be steered by",
                   "Leave it out, use takes that differ in it more, or place them by hand.");
    }
}

} // namespace

double measured(const SpaceParameter& parameter, const PerformedMovement& movement)
{
    const Eigen::Index up = Ground(movement.up).upAxis();
    switch (parameter.measure) {
    case SpaceMeasure::Speed:
        return speedOf(movement);
    case SpaceMeasure::Turning:
        return turningOf(movement);
    case SpaceMeasure::JumpHeight:
        return jumpHeightOf(movement);
    case SpaceMeasure::JumpLength:
        return jumpLengthOf(movement);
    case SpaceMeasure::Height:
        return farthestOf(movement, parameter.vertex)[up];
    case SpaceMeasure::Forward:
        return farthestOf(movement, parameter.vertex)[(up + 1) % 3];
    case SpaceMeasure::Side:
        return farthestOf(movement, parameter.vertex)[(up + 2) % 3];
    case SpaceMeasure::ByHand:
        break;
    }
    return 0;
}

ParameterMap fitParameterMap(const WeightSpace& space, const std::vector<SpaceParameter>& parameters,
                             const std::function<SpacePoint(const SpacePoint& place)>& measure)
{
    ParameterMap map{.dimension = space.dimension(), .coefficients = {}};
    if (map.dimension == 0)
        return map;
    const auto dimension = static_cast<std::size_t>(map.dimension);
    const std::vector<SpacePoint> places = samplePlaces(space);
    std::vector<SpacePoint> values;
    values.reserve(places.size());
    for (const SpacePoint& place : places)
        values.push_back(measure(place));
    requireGrowth(places, values, parameters);
    map.least = map.greatest = values.back();
    for (std::size_t t = places.size() - space.takeCount(); t < places.size(); ++t) {
        for (std::size_t d = 0; d < dimension; ++d) {
            map.least[d] = std::min(map.least[d], values[t][d]);
            map.greatest[d] = std::max(map.greatest[d], values[t][d]);
        }
    }
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(places.size()),
                         1 + map.dimension + map.dimension * (map.dimension + 1) / 2);
    Eigen::MatrixXd wanted(rows.rows(), map.dimension);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        SpacePoint scaled{};
        for (std::size_t d = 0; d < dimension; ++d) {
            scaled[d] =
                (values[static_cast<std::size_t>(i)][d] - map.least[d]) / (map.greatest[d] - map.least[d]);
            wanted(i, static_cast<Eigen::Index>(d)) = places[static_cast<std::size_t>(i)][d];
        }
        rows.row(i) = monomials(scaled, map.dimension);
    }
    map.coefficients = rows.completeOrthogonalDecomposition().solve(wanted).transpose();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const SpacePoint met = measure(space.placeOf(space.at(map.placeOf(values[i]))));
        for (std::size_t d = 0; d < dimension; ++d) {
            const double missed = std::abs(met[d] - values[i][d]);
            map.meanResidual[d] += missed * missed / static_cast<double>(places.size());
            map.worstResidual[d] = std::max(map.worstResidual[d], missed);
        }
    }
    for (double& residual : map.meanResidual)
        residual = std::sqrt(residual);
    return map;
}

} // namespace quadrille
