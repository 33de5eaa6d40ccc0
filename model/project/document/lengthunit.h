// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quadrille {

struct LengthUnit
{
    std::string_view name; ///< as the project file writes it, "cm"
    double metres;
};

/// The units that have a name: m, cm, mm, km, in, ft.
std::span<const LengthUnit> lengthUnits();
/// Metres of a named unit.
std::optional<double> metresPerUnit(std::string_view name);
/// The name of a unit of this length, if it has one.
std::optional<std::string_view> unitName(double metresPerUnit);
/// The name of a unit of this length, or its length in metres: "cm", "0.5 m".
std::string unitText(double metresPerUnit);

} // namespace quadrille
