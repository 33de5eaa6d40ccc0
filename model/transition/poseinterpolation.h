// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/geometry/poissonsystem.h"
#include "model/geometry/poseframes.h"
#include "model/geometry/procrustes.h"
#include "model/geometry/trianglelogs.h"
#include "model/transition/interpolationmethod.h"

#include <memory>
#include <span>
#include <vector>

namespace quadrille {

/// A pose made ready for interpolation from or towards it: frames of its triangles and its factorised Poisson
/// system. Immutable; shared between the pairs that use it.
class PreparedPose
{
public:
    /// \param positions  of all vertices of the system's topology, finite, metres; copied.
    /// Cost: one numeric factorisation (well under a millisecond for 2,700 vertices).
    PreparedPose(std::shared_ptr<const PoissonSystem> system, Positions positions);

    const PoissonSystem& system() const { return *m_system; }
    Positions positions() const { return m_positions; }
    const PoseFrames& frames() const { return m_frames; }
    const PoissonPose& poisson() const { return m_poisson; }
    /// Mean of the vertices that triangles use.
    const Vec3d& centre() const { return m_centre; }
    /// Mean of the vertices of each connected component.
    const std::vector<Vec3d>& componentCentres() const { return m_componentCentres; }

private:
    std::shared_ptr<const PoissonSystem> m_system;
    std::vector<Vec3f> m_positions;
    PoseFrames m_frames;
    PoissonPose m_poisson;
    Vec3d m_centre = Vec3d::Zero();
    std::vector<Vec3d> m_componentCentres;
};

/// The poses between two poses. The rotation between the poses as wholes is removed
/// first and put back interpolated, so is the translation; each triangle turns and stretches in between; two
/// Poisson solves, one with each pose at rest, find the surfaces, which are blended linearly; each connected
/// component is placed by its interpolated centre. Swapping the poses and λ with 1 − λ gives the same result.
/// Immutable; safe from any thread.
class PoseInterpolation
{
public:
    /// \pre Both poses were prepared with one system.
    PoseInterpolation(std::shared_ptr<const PreparedPose> source, std::shared_ptr<const PreparedPose> target);

    /// One pose in between; at 0 and 1 exactly the source and the target.
    /// \param lambda  in [0, 1].
    /// \param out  of all vertices, metres.
    /// \param placeSource, placeTarget  rigid motions of the two poses beforehand: a blend may align them
    /// anew at every step and keep what was prepared.
    void at(double lambda, MutablePositions out, InterpolationMethod method = InterpolationMethod::Poisson,
            const RigidMotion& placeSource = {}, const RigidMotion& placeTarget = {}) const;

    /// Only the source deformed towards the target, or only the target deformed towards the source by 1 − λ
    /// (SMCAS eq. 6–7), turned and placed as by `at`.
    enum class Side
    {
        Source,
        Target,
    };
    void oneSided(Side side, double lambda, MutablePositions out,
                  InterpolationMethod method = InterpolationMethod::Poisson) const;

    /// The rotation that turns the source nearest to the target.
    const Eigen::Quaterniond& rotation() const { return m_rotation; }

private:
    struct Placement;
    std::vector<TriangleEdges> deformedEdges(double lambda, InterpolationMethod method) const;
    void place(const Placement& placement, double lambda, std::span<const std::vector<double>> solutions,
               std::span<const double> weights, MutablePositions out) const;

    std::shared_ptr<const PreparedPose> m_source;
    std::shared_ptr<const PreparedPose> m_target;
    Eigen::Quaterniond m_rotation;
    TriangleLogs m_logs;
    std::vector<int> m_degenerate; ///< triangles without area in either pose
};

/// One pose between two, for a single call; otherwise keep a PoseInterpolation.
/// \throws Error VertexCountMismatch when a pose has another number of vertices than the topology.
std::vector<Vec3f> interpolatePoses(const std::shared_ptr<const Topology>& topology, Positions source,
                                    Positions target, double lambda,
                                    InterpolationMethod method = InterpolationMethod::Poisson);

/// One frame of a blend: a frame of each window and where between them.
struct BlendStep
{
    int source = 0; ///< in the source window
    int target = 0; ///< in the target window
    double lambda = 0;
    RigidMotion placeSource; ///< of the source pose beforehand
    RigidMotion placeTarget; ///< of the target pose beforehand
};

/// Interpolates between the frames of two windows, in parallel over the steps. Every pose is prepared once
/// for as many steps in a row as it takes part in; memory for prepared poses is bounded, whatever the
/// windows. \param sources, targets  frames of the windows, each with all vertices of the topology. \return
/// steps × vertices, metres; the same for any number of threads. \throws Error Cancelled,
/// VertexCountMismatch. \pre The steps' frames lie in the windows.
std::vector<Vec3f> blendPoses(const std::shared_ptr<const PoissonSystem>& system,
                              std::span<const Positions> sources, std::span<const Positions> targets,
                              std::span<const BlendStep> steps,
                              InterpolationMethod method = InterpolationMethod::Poisson,
                              const Progress& progress = {});

} // namespace quadrille
