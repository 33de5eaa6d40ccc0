// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poissonsystem.h"
#include "model/transfer/solidtarget.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// What the harmonic fields over one target share, wherever they are given: the cotangent Laplacian of its
/// surface, components tied at their bridges. Immutable; safe from any thread.
class HarmonicSystem
{
public:
    /// \param weights  of the target's triangles, see PoissonPose::weights. Edges that they make negative
    /// count next to nothing, so that no value of a field leaves the range of those that are given.
    /// Cost: one symbolic factorisation.
    HarmonicSystem(const SolidTarget& target, std::span<const std::array<double, 3>> weights);

    const CholeskyPattern& pattern() const { return m_pattern; }
    /// Of the Laplacian, as CholeskyFactor::factorise takes them.
    const std::vector<double>& values() const { return m_values; }
    /// Per triangle the rows of its corners.
    const std::vector<std::array<int, 3>>& triangleRows() const { return m_triangleRows; }
    int rowOf(std::uint32_t vertex) const { return m_pattern.rowOf(static_cast<int>(vertex)); }

private:
    struct Edges;
    HarmonicSystem(const SolidTarget& target, const Edges& edges);

    CholeskyPattern m_pattern;
    std::vector<double> m_values;
    std::vector<std::array<int, 3>> m_triangleRows;
};

/// Fields of four numbers over a target that are harmonic, ∇²S = 0, but at marked triangles, where they are
/// given (SCANS §4). Immutable; safe from any thread. The system must outlive it.
class HarmonicField
{
public:
    static constexpr std::size_t lanes = CholeskyFactor::lanes;
    using Value = std::array<double, lanes>;

    /// \param marks  triangles of the target, at least one, each once. \param held  of each mark more
    /// vertices that have its value, corners of no mark, each of one mark; or empty. Cost: one numeric
    /// factorisation.
    HarmonicField(const HarmonicSystem& system, std::span<const std::size_t> marks,
                  std::span<const std::vector<std::uint32_t>> held = {});

    /// Solves for one field or three at once.
    /// \param values  at the marks: of each mark those of all fields. Where marked triangles share a corner
    /// it has their mean. \param x  (rows + 1) × 4 · fields: the fields at the vertices, in the order of
    /// HarmonicSystem::rowOf.
    void solve(std::span<const Value> values, std::vector<double>& x) const;

private:
    struct Given
    {
        std::size_t row = 0;
        std::size_t mark = 0;
        double share = 0; ///< of the mark in the row's value, times the weight that holds it
    };

    const HarmonicSystem* m_system;
    std::size_t m_marks;
    CholeskyFactor m_factor;
    std::vector<Given> m_given;
};

} // namespace quadrille
