// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/texturequality.h"

#include <string>
#include <string_view>

namespace quadrille {

/// Which of the two measures of a picture a figure shows.
struct PictureMeasure
{
    std::string name; ///< in columns
    std::string unit;
    double PictureQuality::*value;
    double sign; ///< −1 where less is better
};

inline PictureMeasure pictureMeasureOf(std::string_view table)
{
    if (table == "fig18" || table == "fig20")
        return {"mse", "grey level²", &PictureQuality::meanSquaredError, -1};
    return {"ssim", {}, &PictureQuality::similarity, 1};
}

} // namespace quadrille
