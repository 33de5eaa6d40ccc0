// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/poissonsystem.h"
#include "model/parametric/motionspace.h"

#include <functional>

namespace quadrille {

/// The non-linear blend of a space's takes in all frames (IA4D eq. 1–2): of more than two takes one after the
/// other.
class NonLinearBlend
{
public:
    explicit NonLinearBlend(const MotionSpace& space,
                            InterpolationMethod method = InterpolationMethod::Slerp);

    /// One frame of a blend. \param shares  by take; they add up to 1. \param pose  of all vertices, metres.
    /// \param frame  its number.
    using Use = std::function<void(std::size_t blend, std::size_t frame, Positions pose)>;
    /// Several blends at once, which share what is prepared of the takes: a Poisson system of each frame.
    /// Parallel over the frames; of one frame, blend after blend. \throws Error Cancelled.
    void blend(std::span<const std::vector<double>> shares, const Use& use,
               const Progress& progress = {}) const;
    /// One. \return frames × vertices, metres.
    std::vector<Vec3f> blend(const std::vector<double>& shares) const;

private:
    const MotionSpace& m_space;
    std::shared_ptr<const PoissonSystem> m_system;
    InterpolationMethod m_method;
};

/// How far a hybrid blend is from the non-linear one at a place.
struct HybridError
{
    double greatest = 0; ///< of all vertices in all frames, metres
    double mean = 0;
    std::size_t frame = 0; ///< where it is greatest
};

HybridError hybridError(const MotionSpace& space, const NodeWeights& weights,
                        const NonLinearBlend& nonLinear);

/// Bisects all edges that need it, the worst first, again and again, until in the middle of each edge and of
/// each simplex the hybrid blend is nearer to the non-linear one than nine tenths of the tolerance, which
/// leaves room for places between, or there are as many references as there may be.
/// \throws Error Cancelled.
void refine(MotionSpace& space, const MotionSpaceSettings& settings, const Progress& progress = {});

} // namespace quadrille
