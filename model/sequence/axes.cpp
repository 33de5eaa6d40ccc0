// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/axes.h"

#include <cctype>

namespace quadrille {

namespace {

/// Rotation that takes a system with this axis up to the one with y up.
Eigen::Matrix3f toYUp(UpAxis up)
{
    Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
    if (up == UpAxis::Z)
        rotation << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    else if (up == UpAxis::X)
        rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    return rotation;
}

} // namespace

Eigen::Matrix3f conversionMatrix(const CoordinateSystem& from, const CoordinateSystem& to)
{
    const auto scale = static_cast<float>(from.metresPerUnit / to.metresPerUnit);
    return scale * toYUp(to.up).transpose() * toYUp(from.up);
}

std::string_view toString(UpAxis up)
{
    return up == UpAxis::X ? "x" : up == UpAxis::Y ? "y" : "z";
}

std::optional<UpAxis> upAxisFromString(std::string_view text)
{
    if (text.size() != 1)
        return std::nullopt;
    switch (std::tolower(static_cast<unsigned char>(text[0]))) {
    case 'x':
        return UpAxis::X;
    case 'y':
        return UpAxis::Y;
    case 'z':
        return UpAxis::Z;
    default:
        return std::nullopt;
    }
}

} // namespace quadrille
