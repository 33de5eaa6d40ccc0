// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/steps/charactersteps.h"
#include "model/variation/gpdm/gpdm.h"

#include <string>
#include <vector>

namespace quadrille {

// What results of variations are written and read with.

/// \pre The shape's sizes multiply to the number of values.
inline DataArray arrayOfDoubles(std::string name, std::string description, std::string unit,
                                std::vector<std::int64_t> shape, std::vector<double> values)
{
    DataArray array;
    array.name = std::move(name);
    array.description = std::move(description);
    array.unit = std::move(unit);
    array.shape = std::move(shape);
    array.values = std::move(values);
    return array;
}

/// An array of rows × columns.
inline DataArray matrixArray(std::string name, std::string description, std::string unit,
                             const RowMatrix& matrix)
{
    return arrayOfDoubles(std::move(name), std::move(description), std::move(unit),
                          {matrix.rows(), matrix.cols()}, {matrix.data(), matrix.data() + matrix.size()});
}

/// \pre The result has such an array.
inline const std::vector<double>& doublesOf(const Result& result, const std::string& name)
{
    return std::get<std::vector<double>>(arrayOf(result, name).values);
}

/// Names one behind the other, with commas.
inline std::string joined(const std::vector<std::string>& names)
{
    std::string all;
    for (const std::string& name : names)
        all += (all.empty() ? "" : ", ") + name;
    return all;
}

} // namespace quadrille
