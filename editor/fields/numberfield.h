// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/settingform.h"

#include <optional>
#include <string_view>

class QDoubleSpinBox;

namespace quadrille {

/// What the schema of the project file says of a number.
struct NumberFacts
{
    double least; ///< -infinity where there is none
    bool isAboveLeast;
    double greatest;             ///< infinity where there is none
    std::optional<double> usual; ///< what counts where it is left out
};
/// \param path  definition and key, as “search.dwell”. \pre It is a number of the schema.
NumberFacts factsOf(std::string_view path);

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
};
/// What stands for an empty value: one step below the lowest that is shown.
double emptyNumber(const NumberLook& look);
/// Whether a shown number stands for an empty value: any below the lowest.
bool isEmptyNumber(const NumberLook& look, double shown);
/// It tells its value when typing is done, not with each key. The caller owns it; so for makeRateField().
QDoubleSpinBox* makeNumberField(const NumberLook& look);
/// For frames a second, as exact as the file has them and without zeros at the end. \param mayBeEmpty  with 0
/// for none.
QDoubleSpinBox* makeRateField(bool mayBeEmpty = false);
/// A shown number as the file has it: 70 % are 0.7, to the last digit.
double inFile(const NumberLook& look, double shown);
/// Shows a number that may be beyond what the field lets one enter. Its limit grows for as long as that
/// number is shown.
void showNumber(QDoubleSpinBox& field, double shown);

} // namespace quadrille
