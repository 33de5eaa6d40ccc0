// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"

#include <Eigen/Cholesky>

namespace quadrille {

/// Finds the point of a QuantisedSpace that is nearest to a sample: exact least squares, since rounded
/// components are not quite orthonormal. Factorises once, projects many times, from any thread.
class SpaceProjection
{
public:
    /// \param space  stays where it is for as long as this lives. Cost: O(n · k²).
    explicit SpaceProjection(const QuantisedSpace& space, const Progress& progress = {});

    /// \param sample  n values. \return k coefficients. Cost: O(n · k).
    Eigen::VectorXd project(std::span<const float> sample) const;

private:
    const QuantisedSpace& m_space;
    Eigen::LDLT<Eigen::MatrixXd> m_products;
};

/// Variance of what the components of a space do not explain of a value: the share of a value in the
/// eigenvalues that are left out, and noise. \param deviation  of the noise.
double unexplainedVariance(const QuantisedSpace& space, double deviation);

/// The likeliest point of a space where only some values of a sample are known (maximum a posteriori): each
/// coefficient has its eigenvalue as variance, each value what is unexplained. Where nothing is known, the
/// mean. \param known  per value, 1 or 0. \param unexplained  variance of a value, see above. \return k
/// coefficients. \pre There is an eigenvalue for each component. Cost: O(n · k²).
Eigen::VectorXd likeliestCoefficients(const QuantisedSpace& space, std::span<const float> sample,
                                      std::span<const std::uint8_t> known, double unexplained);

/// How unlikely coefficients are: 1 / eigenvalue of each, which their squares are multiplied by.
Eigen::VectorXd priorPrecisions(const QuantisedSpace& space);

/// The coefficients of an aligned texture and its backward warp, see AppearanceModel.
/// \param texture  3 values per used texel. \param warp  2 values per node. Cost: O(values · components²);
/// for several frames keep two SpaceProjection.
AppearanceCoefficients project(const AppearanceModel& model, std::span<const float> texture,
                               std::span<const float> warp, const Progress& progress = {});

} // namespace quadrille
