// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/results/rebuild.h"
#include "model/project/store/resultstore.h"

namespace quadrille {

/// How a step stands against the store.
struct StepStatus
{
    std::string key;
    bool isFresh = false;
    bool isDamaged = false;
    std::string reason;             ///< why it is not fresh, English
    std::optional<Error> error;     ///< its inputs cannot be read
    std::vector<WrittenFile> files; ///< that its result names, when fresh
};

/// The key of each step, or the error of finding it; `steps` has inputs before what uses them. Reads inputs.
/// \throws Error Cancelled.
std::vector<StepStatus> stepKeys(const std::vector<BuildStep>& steps, FileHashes& hashes,
                                 const Progress& progress);

/// Finds how each step stands; `steps` has inputs before what uses them. Reads inputs and results, computes
/// nothing.
/// \throws Error Cancelled.
std::vector<StepStatus> stepStatus(const std::vector<BuildStep>& steps, const ResultStore& store,
                                   const std::filesystem::path& projectFolder, FileHashes& hashes,
                                   const Progress& progress);

/// The steps that targets mean, together with their inputs, in order.
/// \throws Error ProjectUnknownTarget.
std::vector<BuildStep> selectSteps(const std::vector<BuildStep>& steps,
                                   const std::vector<std::string>& targets);

} // namespace quadrille
