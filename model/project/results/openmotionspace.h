// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/motionspace.h"
#include "model/parametric/similarity.h"
#include "model/project/results/projectresults.h"

#include <memory>
#include <string>

namespace quadrille {

/// A motion space as a rebuild computes it, read where it is up to date; one for all who share the session.
/// \throws Error ProjectInvalid (no such space, or one without takes); as ProjectResults::get.
std::shared_ptr<const MotionSpace> openMotionSpace(const ProjectResults& results, const std::string& name,
                                                   const Progress& progress = {});

/// How far the frames of two motion spaces of one character are apart, likewise.
/// \throws Error ProjectInvalid (the same space twice, none of one of the names, two characters); as
/// ProjectResults::get.
std::shared_ptr<const SimilarityTable> openSimilarities(const ProjectResults& results,
                                                        const std::string& source, const std::string& target,
                                                        const Progress& progress = {});

/// What the properties of a space show.
struct MotionSpaceResult
{
    MotionSpaceEntry entry; ///< as it was then
    std::shared_ptr<const MotionSpace> space;
    DataTable error;      ///< “motion-spaces/NAME/error”
    DataTable parameters; ///< “motion-spaces/NAME/parameters”
};
using MotionSpaceResultPointer = std::shared_ptr<const MotionSpaceResult>;

/// A motion space with what is known of its quality. \throws Error as openMotionSpace.
MotionSpaceResultPointer openMotionSpaceResult(const ProjectResults& results, const std::string& name,
                                               const Progress& progress = {});

} // namespace quadrille
