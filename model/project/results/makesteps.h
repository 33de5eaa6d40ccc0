// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/buildstep.h"

#include <vector>

namespace quadrille {

/// All steps of a project, each after its inputs. New capabilities add theirs here.
std::vector<BuildStep> makeSteps(const StepMaking& making);

/// A step that needs what nothing makes fails with a sentence; its inputs are those that there are.
void refuseMissingInputs(std::vector<BuildStep>& steps);

} // namespace quadrille
