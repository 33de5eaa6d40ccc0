// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/lengthunit.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace quadrille {

std::span<const LengthUnit> lengthUnits()
{
    static constexpr std::array<LengthUnit, 6> units{
        {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000.0}, {"in", 0.0254}, {"ft", 0.3048}}};
    return units;
}

std::optional<double> metresPerUnit(std::string_view name)
{
    const auto units = lengthUnits();
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const LengthUnit& unit) { return unit.name == name; });
    return found == units.end() ? std::nullopt : std::optional(found->metres);
}

std::optional<std::string_view> unitName(double metresPerUnit)
{
    const auto units = lengthUnits();
    const auto found = std::find_if(units.begin(), units.end(),
                                    [&](const LengthUnit& unit) { return unit.metres == metresPerUnit; });
    return found == units.end() ? std::nullopt : std::optional(found->name);
}

std::string unitText(double metresPerUnit)
{
    if (const auto name = unitName(metresPerUnit))
        return std::string(*name);
    return nlohmann::json(metresPerUnit).dump() + " m";
}

} // namespace quadrille
