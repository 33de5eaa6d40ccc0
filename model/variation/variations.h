// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/feet.h"
#include "model/synthesis/clips/clip.h"
#include "model/variation/parts/stitching.h"
#include "model/variation/posedraw.h"
#include "model/variation/sampling.h"
#include "model/variation/standing.h"
#include "model/variation/subject.h"

#include <memory>
#include <vector>

namespace quadrille {

/// A movement with the models of all its parts, ready to draw from. Immutable; safe from any thread.
class LearnedMovement
{
public:
    /// \param states  of each part, as learned.
    LearnedMovement(std::shared_ptr<const Movement> movement, std::vector<GpdmState> states);

    const Movement& movement() const { return *m_movement; }
    std::size_t partCount() const { return m_states.size(); }
    const GpdmState& state(std::size_t part) const { return m_states.at(part); }
    const GpdmDynamics& dynamics(std::size_t part) const { return m_dynamics.at(part); }
    const PoseReconstruction& poses(std::size_t part) const { return m_poses.at(part); }
    const Stitching& stitching() const { return m_stitching; }
    /// The learned latent trajectory of a take, frames × dimensions.
    RowMatrix trajectory(std::size_t part, std::size_t take) const;

private:
    std::shared_ptr<const Movement> m_movement;
    std::vector<GpdmState> m_states;
    std::vector<GpdmDynamics> m_dynamics;
    std::vector<PoseReconstruction> m_poses;
    Stitching m_stitching;
};

/// The latent trajectories of all parts of one variation.
using LatentVariation = std::vector<RowMatrix>;

/// Latent variations of one part.
struct PartVariations
{
    std::vector<RowMatrix> trajectories; ///< each reference frames × dimensions
    std::vector<SampleReport> reports;   ///< of each trajectory that was drawn around
};

/// Draws latent variations of one part of a subject (CVS §6 and §7). Of a blend each is drawn around all
/// learned trajectories next to it, around one always with the same random numbers: so it follows the weights
/// without a jump. They are drawn as much further apart as blending brings them together again.
/// \param seed  of all parts together. \throws Error as subjectTakes; Cancelled.
PartVariations drawPart(const Movement& movement, std::size_t part, const GpdmState& state,
                        const VariationSubject& subject, int count, std::uint64_t seed,
                        const SamplingSettings& settings = {}, const Progress& progress = {});

struct LatentVariations
{
    std::vector<LatentVariation> variations;
    std::vector<std::vector<SampleReport>>
        reports; ///< of each part, of each trajectory that was drawn around
};

/// Draws latent variations of all parts, independently and in parallel.
/// \return the same for any number of threads. \throws Error as drawPart.
LatentVariations sampleLatents(const LearnedMovement& learned, const VariationSubject& subject, int count,
                               std::uint64_t seed, const SamplingSettings& settings = {},
                               const Progress& progress = {});

/// What keeps the feet of variations still while they stand.
struct VariationContacts
{
    CharacterFrames character; ///< the captured takes, with their contacts
    Legs legs;                 ///< without any nothing is corrected
};

struct VariationPoses
{
    PoseDraw draw = PoseDraw::Mean;
    std::uint64_t seed = 1; ///< of draws
    UpAxis up = UpAxis::Y;
    /// What of the captured frames stands: the way follows the steps then (see keepStanding). Null: it
    /// follows the displacements alone.
    const CapturedStanding* standing = nullptr;
    /// How much faster or slower than its take a variation may be, as a share of how durations of takes of
    /// the same movement differ (wayRange); 0: as fast.
    double tempo = 0;
    /// Null: feet slip as the poses and the way let them.
    const VariationContacts* contacts = nullptr;
};

/// One variation as a clip: parts reconstructed, stitched and moved over the ground by a way that differs
/// from what it varies no further than takes do (boundedPath), in its timing, at a tempo that the seed draws.
/// \param layout  the frames of the captured takes, which origins count.
/// \throws Error as subjectTakes; Cancelled.
Clip makeVariation(const LearnedMovement& learned, const VariationSubject& subject,
                   const LatentVariation& latents, const FrameLayout& layout,
                   const VariationPoses& settings = {}, const Progress& progress = {});

/// The coefficients that belong to makeVariation's clip, of the same draw: of each kind its frames × values;
/// nothing where the movement has none. \throws Error as subjectTakes.
std::vector<RowMatrix> variationCoefficients(const LearnedMovement& learned, const VariationSubject& subject,
                                             const LatentVariation& latents,
                                             const VariationPoses& settings = {});

/// The poses of a variation on the reference's frames, laid onto the template, without the displacement:
/// frames × vertices.
std::vector<Vec3f> variationPoses(const LearnedMovement& learned, const LatentVariation& latents,
                                  const VariationPoses& settings = {}, const Progress& progress = {});

} // namespace quadrille
