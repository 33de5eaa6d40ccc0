// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace quadrille {

/// The axis that points up; the system is right-handed.
enum class UpAxis
{
    X,
    Y,
    Z,
};

/// The coordinates of a file: which axis is up and how long a unit is.
struct CoordinateSystem
{
    UpAxis up = UpAxis::Y;
    double metresPerUnit = 1.0;
    bool operator==(const CoordinateSystem&) const = default;
};

/// The matrix that takes positions from one system to another: a rotation of the axes times the ratio of the
/// units. Y up and Z up are exchanged by a quarter turn about x, so that a figure keeps facing the viewer.
Eigen::Matrix3f conversionMatrix(const CoordinateSystem& from, const CoordinateSystem& to);

std::string_view toString(UpAxis up);
/// "x", "y" or "z", in either case.
std::optional<UpAxis> upAxisFromString(std::string_view text);

} // namespace quadrille
