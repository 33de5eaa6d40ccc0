// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transfer/harmonicfield.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

/// Of an edge whose cotangents are below it, and the weight of bridges is that of equilateral triangles.
constexpr double leastWeight = 1e-6;
constexpr double bridgeWeight = 0.57735026918962573;
/// How firmly given values are held, in weights of an edge: they are met to eight digits.
constexpr double holdWeight = 1e8;

} // namespace

/// Edges of the surface and bridges, each once, with their weights.
struct HarmonicSystem::Edges
{
    Edges(const SolidTarget& target, std::span<const std::array<double, 3>> triangleWeights);

    std::vector<std::array<int, 2>> ends;
    std::vector<double> weights;
};

HarmonicSystem::Edges::Edges(const SolidTarget& target,
                             std::span<const std::array<double, 3>> triangleWeights)
{
    struct Side
    {
        std::array<int, 2> ends;
        double weight;
    };
    std::vector<Side> sides;
    const std::vector<Triangle>& triangles = target.topology()->triangles();
    sides.reserve(3 * triangles.size() + target.bridges().size());
    const auto add = [&](std::uint32_t a, std::uint32_t b, double weight) {
        const auto [low, high] = std::minmax(a, b);
        sides.push_back({{static_cast<int>(low), static_cast<int>(high)}, weight});
    };
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c)
            add(triangles[t][(c + 1) % 3].value, triangles[t][(c + 2) % 3].value, triangleWeights[t][c]);
    }
    for (const SolidTarget::Bridge& bridge : target.bridges()) {
        if (bridge.vertex != bridge.onto)
            add(bridge.vertex, bridge.onto, bridgeWeight);
    }
    std::ranges::stable_sort(sides, {}, &Side::ends);
    for (const Side& side : sides) {
        if (ends.empty() || ends.back() != side.ends) {
            ends.push_back(side.ends);
            weights.push_back(0);
        }
        weights.back() += side.weight;
    }
    for (double& weight : weights)
        weight = std::max(weight, leastWeight);
}

HarmonicSystem::HarmonicSystem(const SolidTarget& target, std::span<const std::array<double, 3>> weights)
    : HarmonicSystem(target, Edges(target, weights))
{
}

HarmonicSystem::HarmonicSystem(const SolidTarget& target, const Edges& edges)
    : m_pattern(static_cast<int>(target.positions().size()), edges.ends)
{
    const auto rows = static_cast<std::size_t>(m_pattern.size());
    m_values.assign(rows + edges.ends.size(), 0.0);
    for (std::size_t e = 0; e < edges.ends.size(); ++e) {
        for (const int end : edges.ends[e])
            m_values[static_cast<std::size_t>(m_pattern.rowOf(end))] += edges.weights[e];
        m_values[rows + e] = -edges.weights[e];
    }
    m_triangleRows.reserve(target.topology()->triangles().size());
    for (const Triangle& t : target.topology()->triangles())
        m_triangleRows.push_back({rowOf(t[0].value), rowOf(t[1].value), rowOf(t[2].value)});
}

HarmonicField::HarmonicField(const HarmonicSystem& system, std::span<const std::size_t> marks,
                             std::span<const std::vector<std::uint32_t>> held)
    : m_system(&system), m_marks(marks.size())
{
    std::map<int, int> marksAt; // of each row that is given
    for (const std::size_t mark : marks) {
        for (const int row : system.triangleRows()[mark])
            ++marksAt[row];
    }
    for (std::size_t m = 0; m < marks.size(); ++m) {
        for (const int row : system.triangleRows()[marks[m]])
            m_given.push_back({static_cast<std::size_t>(row), m, holdWeight / marksAt.at(row)});
    }
    for (std::size_t m = 0; m < held.size(); ++m) {
        for (const std::uint32_t vertex : held[m]) {
            m_given.push_back({static_cast<std::size_t>(system.rowOf(vertex)), m, holdWeight});
            marksAt[system.rowOf(vertex)] = 1;
        }
    }
    std::vector<double> values = system.values();
    for (const auto& [row, count] : marksAt)
        values[static_cast<std::size_t>(row)] += holdWeight;
    m_factor.factorise(system.pattern(), values);
}

void HarmonicField::solve(std::span<const Value> values, std::vector<double>& x) const
{
    const std::size_t fields = values.size() / m_marks;
    x.assign((static_cast<std::size_t>(m_system->pattern().size()) + 1) * lanes * fields, 0.0);
    for (const Given& given : m_given) {
        for (std::size_t f = 0; f < fields; ++f) {
            for (std::size_t l = 0; l < lanes; ++l)
                x[(given.row * fields + f) * lanes + l] += given.share * values[given.mark * fields + f][l];
        }
    }
    m_factor.solve(x, fields);
}

} // namespace quadrille
