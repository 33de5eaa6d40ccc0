// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/buildstep.h"

#include <memory>
#include <vector>

namespace quadrille {

class WriteGuard;

/// The steps of a project's exports, which write as a guard allows.
std::vector<BuildStep> exportSteps(const std::shared_ptr<SequenceOpener>& opener,
                                   const std::shared_ptr<WriteGuard>& guard);
/// The same with a guard that allows nothing beyond the project's own files.
std::vector<BuildStep> makeExportSteps(const StepMaking& making);

} // namespace quadrille
