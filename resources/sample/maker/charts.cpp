// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/atlas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace quadrille {

namespace {

const std::vector<std::string> chartNames = {
    "head front",        "head back",          "torso front",        "torso back",
    "left arm front",    "left arm back",      "right arm front",    "right arm back",
    "left hand back",    "left palm",          "right hand back",    "right palm",
    "left leg front",    "left leg back",      "right leg front",    "right leg back",
    "left shoe outer",   "left shoe inner",    "right shoe outer",   "right shoe inner",
    "left sole",         "right sole",         "left index finger",  "left middle finger",
    "left ring finger",  "left little finger", "right index finger", "right middle finger",
    "right ring finger", "right little finger"};

/// 0 for the index finger … 3 for the little one: they fan out from the knuckles.
int nearestFinger(double along, double toThumb)
{
    int nearest = 0;
    double distance = 1;
    int finger = 0;
    for (const auto& [offset, slope] :
         {std::pair{0.0300, 0.15}, {0.0100, 0.035}, {-0.0105, -0.10}, {-0.0300, -0.27}}) {
        if (const double d = std::abs(toThumb - offset - slope * (along - 0.085)); d < distance) {
            distance = d;
            nearest = finger;
        }
        ++finger;
    }
    return nearest;
}

/// Where the middle of the hand lies between palm and back, for a place along the hand: fingers curl.
double handMiddle(double along, double toThumb)
{
    if (toThumb > 0.046 && along < 0.10)
        return -0.021;
    constexpr std::array<double, 4> lengths = {0.078, 0.086, 0.080, 0.064};
    const auto finger = static_cast<std::size_t>(nearestFinger(along, toThumb));
    const double way = (along - 0.084) / lengths[finger];
    return way < 0.5 ? -0.008 * std::max(way, 0.0) : -0.004 - 0.026 * (way - 0.5);
}

std::uint16_t wishedChart(const Body& body, const Vec3d& point, const Vec3d& normal)
{
    const FigurePart part = body.partAt(point);
    Vec3d p = body.toReference(point, part);
    const int right = p.x() < 0 ? 1 : 0;
    p.x() = std::abs(p.x());
    const BodyJoints joints = referenceJoints();
    const auto chart = [&](int first, int perSide, bool second) {
        return static_cast<std::uint16_t>(first + perSide * right + (second ? 1 : 0));
    };
    switch (part) {
    case FigurePart::Head:
        return p.z() < -0.022 + 0.15 * (p.y() - 1.60) ? 1 : 0;
    case FigurePart::Torso:
        return p.z() < -0.012 ? 3 : 2;
    case FigurePart::Arm:
        return chart(4, 2, p.z() < joints.shoulder.z());
    case FigurePart::Hand: {
        const Vec3d along = (joints.elbow - joints.shoulder).normalized();
        const Vec3d q = p - joints.wrist;
        const Vec3d out = Vec3d(-along.y(), along.x(), 0);
        const double way = q.dot(along);
        const bool isPalm = q.dot(out) < handMiddle(way, q.z());
        // Fingers laid flat on the palm's side are wider than they are apart: each is a chart of its own.
        if (isPalm && way > 0.104 && q.z() < 0.052)
            return static_cast<std::uint16_t>(22 + 4 * right + nearestFinger(way, q.z()));
        return chart(8, 2, isPalm);
    }
    case FigurePart::Leg: {
        const double middle = p.y() > 0.85 ? 0.0 : -0.02 + 0.026 * std::min((p.y() - 0.07) / 0.44, 1.0);
        return chart(12, 2, p.z() < middle);
    }
    case FigurePart::Foot:
        break;
    }
    if (normal.y() < -0.55 && p.y() < 0.04)
        return static_cast<std::uint16_t>(20 + right);
    const Vec3d ahead = (joints.toeTip - joints.ankle).cwiseProduct(Vec3d(1, 0, 1)).normalized();
    const Vec3d q = p - joints.ankle;
    return chart(16, 2, q.x() * ahead.z() - q.z() * ahead.x() < -0.002);
}

using Neighbours = std::vector<std::array<std::int64_t, 3>>;

/// Per triangle the triangles across its edges; −1 where there is none.
Neighbours trianglesAcross(const SurfaceMesh& mesh)
{
    Neighbours across(mesh.triangles.size(), {-1, -1, -1});
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>> open;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t a = mesh.triangles[t][c].value;
            const std::uint32_t b = mesh.triangles[t][(c + 1) % 3].value;
            const auto [it, isNew] = open.try_emplace(std::minmax(a, b), t, c);
            if (isNew)
                continue;
            across[t][c] = static_cast<std::int64_t>(it->second.first);
            across[it->second.first][it->second.second] = static_cast<std::int64_t>(t);
        }
    return across;
}

/// Triangles that two neighbours outvote change sides.
void smoothBorders(std::vector<std::uint16_t>& labels, const Neighbours& across)
{
    for (int pass = 0; pass < 4; ++pass)
        for (std::size_t t = 0; t < labels.size(); ++t)
            for (std::size_t c = 0; c < 3; ++c) {
                const std::int64_t a = across[t][c];
                const std::int64_t b = across[t][(c + 1) % 3];
                if (a < 0 || b < 0)
                    continue;
                const std::uint16_t one = labels[static_cast<std::size_t>(a)];
                if (one == labels[static_cast<std::size_t>(b)] && one != labels[t])
                    labels[t] = one;
            }
}

/// Everything but the largest piece of each chart goes to the chart around it.
void joinIslands(std::vector<std::uint16_t>& labels, const Neighbours& across)
{
    std::vector<std::int32_t> piece(labels.size(), -1);
    std::vector<std::vector<std::size_t>> pieces;
    for (std::size_t seed = 0; seed < labels.size(); ++seed) {
        if (piece[seed] >= 0)
            continue;
        const auto id = static_cast<std::int32_t>(pieces.size());
        std::vector<std::size_t> members = {seed};
        piece[seed] = id;
        for (std::size_t i = 0; i < members.size(); ++i)
            for (const std::int64_t n : across[members[i]]) {
                if (n < 0 || piece[static_cast<std::size_t>(n)] >= 0 ||
                    labels[static_cast<std::size_t>(n)] != labels[seed])
                    continue;
                piece[static_cast<std::size_t>(n)] = id;
                members.push_back(static_cast<std::size_t>(n));
            }
        pieces.push_back(std::move(members));
    }
    std::vector<std::size_t> largest(chartNames.size(), 0);
    for (const auto& members : pieces)
        largest[labels[members.front()]] = std::max(largest[labels[members.front()]], members.size());
    const std::vector<std::uint16_t> before = labels;
    for (const auto& members : pieces) {
        if (members.size() == largest[before[members.front()]])
            continue;
        std::vector<int> votes(chartNames.size(), 0);
        for (const std::size_t t : members)
            for (const std::int64_t n : across[t])
                if (n >= 0 && before[static_cast<std::size_t>(n)] != before[t])
                    ++votes[before[static_cast<std::size_t>(n)]];
        const auto winner =
            static_cast<std::uint16_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
        for (const std::size_t t : members)
            labels[t] = winner;
    }
}

} // namespace

ChartLabels cutCharts(const SurfaceMesh& mesh, const Body& body)
{
    ChartLabels charts;
    charts.names = chartNames;
    for (const Triangle& t : mesh.triangles) {
        const Vec3d& a = mesh.points[t[0].value];
        const Vec3d& b = mesh.points[t[1].value];
        const Vec3d& c = mesh.points[t[2].value];
        charts.ofTriangle.push_back(wishedChart(body, (a + b + c) / 3, (b - a).cross(c - a).normalized()));
    }
    const Neighbours across = trianglesAcross(mesh);
    for (int pass = 0; pass < 3; ++pass) {
        smoothBorders(charts.ofTriangle, across);
        joinIslands(charts.ofTriangle, across);
    }
    return charts;
}

} // namespace quadrille
