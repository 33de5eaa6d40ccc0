// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// One of the papers' tables, to be computed for the characters of the project.
struct EvaluationEntry
{
    std::string table;          ///< one of evaluationTables
    std::string character;      ///< all characters where it is left out
    std::vector<double> alphas; ///< fig9: weights of time; those of the paper where there are none
    nlohmann::ordered_json unknown;

    bool operator==(const EvaluationEntry&) const = default;
};

/// The tables that can be computed, by their numbers in SMCAS.
inline constexpr std::array<std::string_view, 3> evaluationTables{
    "fig7",   ///< kinds of transitions
    "fig9",   ///< Essential graph and motion graph
    "table1", ///< pose distances against reference joint angles
};

} // namespace quadrille
