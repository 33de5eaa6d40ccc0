// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace quadrille {

// Names of the stages of an entry of “variations”.
std::string alignmentStageOf(const std::string& variation);
std::string modelStageOf(const std::string& variation, const std::string& part);
std::string samplesStageOf(const std::string& variation, const std::string& part);
std::string selectionStageOf(const std::string& variation);

} // namespace quadrille
