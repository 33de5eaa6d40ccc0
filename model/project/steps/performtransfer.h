// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/transferbodies.h"
#include "model/synthesis/clips/clip.h"
#include "model/transfer/limbdirections.h"

#include <vector>

namespace quadrille {

/// Which triangles of a transfer turn alike, and from which pose of the template on.
struct TransferMarks
{
    std::vector<ProposedPair> chosen;
    std::vector<TrianglePair> pairs; ///< the same, without their quality
    PosedMesh reference;
};

/// \throws Error as TransferBodies::pairs and …::referencePose.
TransferMarks transferMarks(const TransferBodies& bodies, const TransferBodies::Tell& tell,
                            const Progress& progress);

/// A clip as a target performs it, metres, and how well it went.
struct PerformedTransfer
{
    Clip clip; ///< origins: all frames show the target's
    /// Of each frame: shares of the target's volume at rest, before feet are corrected; empty where it has
    /// none.
    std::vector<double> volume;
    std::vector<double> markErrors; ///< of each frame: mean angle that marked triangles miss, radians
};

/// Makes the clip of a transfer; feet that stand stand still where the entry says so.
/// \param settings  those of the bodies, or others. \param tell  takes what is not as it was asked for.
/// \throws Error as transferClip and contactsCorrected but for NoFeet. Cost: that of both.
PerformedTransfer performTransfer(const TransferBodies& bodies, const TransferMarks& marks,
                                  const TransferSettings& settings, const TransferBodies::Tell& tell,
                                  const Progress& progress);

/// By how much the limbs of a performance miss the directions that those of the template have, in each frame;
/// not a number where one of the bodies has no arms and legs. \param performance  metres.
std::vector<LimbErrors> limbErrors(const TransferBodies& bodies, const PosedMesh& reference,
                                   const Clip& performance, const Progress& progress);

/// How fast the feet that stand until the next frame slide, m/s; not a number where none does.
/// \param performance  metres, with contacts. \throws Error as findStances.
std::vector<double> footSlides(const MeshSequence& performance, UpAxis up, const Progress& progress);

/// A clip in metres as a sequence that stands when another does.
MeshSequence standingAs(const MeshSequence& performed, const Clip& clip);

} // namespace quadrille
