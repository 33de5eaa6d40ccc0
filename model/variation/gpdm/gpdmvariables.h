// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/variation/gpdm/gpdm.h"

#include <string>
#include <vector>

namespace quadrille {

/// Latents and hyperparameters as one row of unbounded numbers for an optimiser: first those of the latents,
/// row after row, then one u of each hyperparameter but α₂, ln(hyperparameter) = L·tanh(u/L), L = ln 1e6.
/// Latents X stand as Z = X − smoothness·X″ (second differences within each sequence, its ends free): a step
/// of an optimiser that knows no directions yet then is a smooth one.
class GpdmVariables
{
public:
    GpdmVariables(std::span<const RowSpan> spans, Eigen::Index dimensions, double smoothness);

    Eigen::Index count() const { return m_frames * m_dimensions + hyperparameters; }
    void write(const GpdmState& state, double* variables) const;
    GpdmState read(const double* variables) const;
    /// Derivatives by the variables from those by what they stand for.
    void writeGradient(const GpdmState& state, const GpdmObjective::Gradient& gradient, double* out) const;

private:
    static constexpr Eigen::Index hyperparameters = 6;

    /// X from Z, in place; the derivatives by Z from those by X as well.
    void smooth(Eigen::Map<RowMatrix> values) const;

    std::vector<RowSpan> m_spans;
    Eigen::Index m_frames;
    Eigen::Index m_dimensions;
    double m_smoothness;
    std::vector<double> m_pivots; ///< of the elimination of X from Z, of each frame
};

/// Names of the hyperparameters that are within a thousandth of L of a bound, in logarithms: "alpha1", …
std::vector<std::string> hyperparametersAtBounds(const GpdmHyperparameters& parameters);

} // namespace quadrille
