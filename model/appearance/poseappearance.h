// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/appearancemodel.h"
#include "model/appearance/kernelregression.h"
#include "model/sequence/meshsequence.h"

#include <functional>
#include <vector>

namespace quadrille {

/// Captured poses by some vertices of each, laid on the first pose by a rigid motion.
struct PosePlaces
{
    std::vector<std::uint32_t> vertices; ///< that are compared, ascending
    std::vector<float> positions;        ///< poses × vertices × 3

    std::int64_t count() const
    {
        return vertices.empty() ? 0 : std::ssize(positions) / (3 * std::ssize(vertices));
    }
    bool operator==(const PosePlaces&) const = default;
};

/// \param pose  reads one of them, in order. \param vertexCount  of all, at least one; up to 1000 of them are
/// compared, evenly spread by their numbers. \throws Error what reading throws, Cancelled.
PosePlaces posePlaces(std::int64_t count, std::uint32_t vertexCount,
                      const std::function<Frame(std::int64_t pose)>& pose, const Progress& progress = {});

/// Mean squared distances of the vertices of all pairs of poses, count × count.
/// \throws Error Cancelled. Cost: O(count² · vertices).
Eigen::MatrixXd squaredDistances(const PosePlaces& places, const Progress& progress = {});
/// Those of a pose from all. \pre It has the vertices that are compared.
Eigen::VectorXd squaredDistances(const PosePlaces& places, Positions pose);

/// The coefficients of some samples of a space, rows × count.
Eigen::MatrixXd coefficientRows(const QuantisedSpace& space, std::span<const std::int64_t> samples);

/// How Eigen textures and Eigen warps are regressed on poses.
struct PoseScales
{
    RegressionScale textures;
    RegressionScale warps;

    bool operator==(const PoseScales&) const = default;
};

/// Appearance that varies with shape: the coefficients of a pose that nobody captured, learned from those of
/// captured poses (CVS names that as future work). Where no captured pose is near, the mean of them. From any
/// number of threads.
class PoseAppearance
{
public:
    /// \param textures,warps  poses × components. \pre There is a pose. Cost: O(poses³ + poses² · vertices).
    PoseAppearance(const PosePlaces& places, const Eigen::MatrixXd& textures, const Eigen::MatrixXd& warps,
                   const PoseScales& scales);

    /// Whether poses of so many vertices can be looked up.
    bool fits(std::uint32_t vertexCount) const { return m_places.vertices.back() < vertexCount; }
    /// \pre fits(). Cost: O(poses · vertices), 1 ms for 300 poses.
    AppearanceCoefficients at(Positions pose) const;

private:
    PoseAppearance(PosePlaces places, const Eigen::MatrixXd& squaredDistances,
                   const Eigen::MatrixXd& textures, const Eigen::MatrixXd& warps, const PoseScales& scales);

    PosePlaces m_places;
    KernelRegression m_textures;
    KernelRegression m_warps;
};

} // namespace quadrille
