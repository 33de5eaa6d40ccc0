// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/project/document/transferentry.h"
#include "model/project/media/opensequence.h"
#include "model/project/results/projectresults.h"
#include "model/transfer/bodyalignment.h"
#include "model/transfer/bodyplaces.h"
#include "model/transfer/pairproposal.h"
#include "model/transfer/transfersolver.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A transfer as it can be looked at before it is computed; a value that several threads may hold. Positions
/// are in the project's unit.
struct TransferPreview
{
    TransferEntry entry; ///< as it was then
    std::shared_ptr<const OpenedSequence> target;
    std::shared_ptr<const TransferTarget> solid; ///< of the target; null where it is no mesh to solve on
    /// Null where no limbs were found, so for the next. In another pose of the template it is not made again.
    std::shared_ptr<const BodyPlaces> templatePlaces;
    std::shared_ptr<const BodyPlaces> targetPlaces;
    /// Of the template as in `reference`; null without both.
    std::shared_ptr<const BodyAlignment> alignment;
    MeshSequence performed;          ///< the clip
    MeshSequence reference;          ///< one frame: the pose of the template that the target's is like
    MeshSequence rest;               ///< one frame: the target, turned as the template
    std::vector<ProposedPair> pairs; ///< of the entry, else proposed ones
    /// The target performs the clip: its poses are made when they are read. Without contacts corrected.
    /// Nothing in a first look, or where there is a failure.
    std::optional<MeshSequence> posed;
    double sizeRatio = 1;         ///< of the heights of target and template
    std::optional<Error> failure; ///< why there are no pairs, or nothing is posed

    // What solid and places were made of.
    PosedMesh targetPose;   ///< metres
    PosedMesh templatePose; ///< metres; that of `reference`
    UpAxis up = UpAxis::Y;
};

using TransferPreviewPointer = std::shared_ptr<const TransferPreview>;

/// \param before  an earlier one of the same transfer, whose parts are used again where they still hold; may
/// be null. \param show  takes a first look where the target was not known before: both bodies as they stand,
/// without pairs and places; may be empty. \throws Error where clip or target cannot be opened, or have no
/// such frame; ProjectInvalid where there is no such transfer; Cancelled.
TransferPreviewPointer previewTransfer(const ProjectResults& results, const std::string& name,
                                       TransferPreviewPointer before, const Progress& progress = {},
                                       const std::function<void(TransferPreviewPointer)>& show = {});

/// A transfer that was computed.
struct TransferResult
{
    TransferEntry entry;   ///< as it was then
    MeshSequence sequence; ///< as “clip:transfers/NAME” has it
    DataTable report;      ///< of each frame: volume, mark-, limb- and foot-error (degrees), skate (m/s)
};

using TransferResultPointer = std::shared_ptr<const TransferResult>;

/// Opens a transfer from its results, which are brought up to date first. \throws Error of the step that
/// failed; ProjectInvalid where there is no such transfer; Cancelled.
TransferResultPointer openTransfer(const ProjectResults& results, const std::string& name,
                                   const Progress& progress = {});

} // namespace quadrille
