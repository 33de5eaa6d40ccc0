// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/json.h"

#include <optional>
#include <string_view>

namespace quadrille {

/// The JSON schema (draft 7) of the project file, with descriptions, ranges and defaults. The file of it in
/// resources/schema is written by the test that compares both.
Json projectSchema();

/// What the schema says of a number.
struct NumberFacts
{
    double least; ///< -infinity where there is none
    bool isAboveLeast;
    double greatest;             ///< infinity where there is none
    std::optional<double> usual; ///< what counts where it is left out
};
/// \param path  definition and key, as “search.dwell”. \pre It is a number of the schema.
NumberFacts factsOf(std::string_view path);

} // namespace quadrille
