// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace quadrille {

// Names of the steps of an entry of “variations”.
std::string alignmentStepOf(const std::string& variation);
std::string modelStepOf(const std::string& variation, const std::string& part);
std::string samplesStepOf(const std::string& variation, const std::string& part);
std::string selectionStepOf(const std::string& variation);

} // namespace quadrille
