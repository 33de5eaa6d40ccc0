// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/matrixpyramid.h"

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace quadrille::widgets {

/// What cells hold that hold nothing.
inline constexpr float nothing = std::numeric_limits<float>::infinity();

/// A sixth of the cells holds nothing, the others from 0 to 1; lengths are below 40.
inline MatrixValues randomValues(int side, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0.0F, 1.2F);
    const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    auto values = std::make_shared<std::vector<float>>(count);
    auto lengths = std::make_shared<std::vector<std::uint16_t>>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float drawn = value(random);
        (*values)[i] = drawn > 1 ? nothing : drawn;
        (*lengths)[i] = static_cast<std::uint16_t>(random() % 40);
    }
    return {side, std::shared_ptr<const float>(values, values->data()),
            std::shared_ptr<const std::uint16_t>(lengths, lengths->data())};
}

} // namespace quadrille::widgets
