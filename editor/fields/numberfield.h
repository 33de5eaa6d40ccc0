// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/settingform.h"
#include "model/project/fields/members.h"
#include "model/project/fields/schema.h"

#include <functional>
#include <optional>
#include <string_view>

class QDoubleSpinBox;

namespace quadrille {

/// How a field shows a number.
struct NumberLook
{
    const char* path;  ///< in the schema, whose limits are those of the field; null: none there
    double scale = 1;  ///< of one shown unit, in those of the file: 0.01 for percent
    double step = 0.1; ///< shown, as what follows
    int decimals = 2;
    SettingForm::Text unit = {};      ///< with the space before it
    SettingForm::Text automatic = {}; ///< what an empty value is called; empty: there is always one
    double lowest = 0;                ///< where the file takes less, or has no end
    double highest = 1000;
    /// Of a length in the project's unit: that unit, in metres. The look is then of metres, and the field
    /// reaches as far as a path may, to both sides where the lowest is below zero.
    std::function<double()> metresPerUnit = {};
    bool trimsZeros = false; ///< no zeros are shown at the end of its decimals
    /// Where stepping up from an empty value leads; 0: to what counts then, where the schema says it.
    double first = 0;
};
/// Of frames a second, as exact as the file has them. \param automatic  see NumberLook.
NumberLook rateLook(const char* path, SettingForm::Text automatic = {});
/// What stands for an empty value: zero where the lowest that is shown is above, else one step below it.
double emptyNumber(const NumberLook& look);
/// Whether a shown number stands for an empty value: any below the lowest.
bool isEmptyNumber(const NumberLook& look, double shown);
/// It tells its value when typing is done, not with each key. The caller owns it.
QDoubleSpinBox* makeNumberField(const NumberLook& look);
/// A shown number as the file has it: 70 % are 0.7, to the last digit.
double inFile(const NumberLook& look, double shown);
/// Gives a field for a length the steps, decimals and ends that suit the project's unit, and the unit's name.
/// Nothing happens to others.
void showInUnit(QDoubleSpinBox& field, const NumberLook& look);
/// Shows a number that may be beyond what the field lets one enter. Its limit grows for as long as that
/// number is shown.
void showNumber(QDoubleSpinBox& field, double shown);

/// A member of an entry as a number, and back; nothing for an optional one that is empty.
template <typename Value>
std::optional<double> toNumber(const Value& value)
{
    if constexpr (!IsOptional<Value>::value)
        return static_cast<double>(bare(value));
    else
        return value ? std::optional(static_cast<double>(bare(*value))) : std::nullopt;
}
template <typename Value>
Value toValue(double number)
{
    using Number = typename Plain<Value>::Type;
    return Number{static_cast<decltype(bare(Number()))>(number)};
}

} // namespace quadrille
