// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "tests/model/variation/smoothmovement.h"

#include "model/core/random.h"

#include <cmath>
#include <numbers>

namespace quadrille::test {

SmoothMovement smoothMovement(int takes, Eigen::Index framesOfTake, Eigen::Index coordinates,
                              std::uint64_t seed, double noise)
{
    constexpr Eigen::Index waves = 6;
    Random random(seed);
    const auto normals = [&random](Eigen::Index rows, Eigen::Index columns) {
        return RowMatrix(RowMatrix::NullaryExpr(rows, columns, [&random] { return random.normal(); }));
    };
    // A pose is the phase of its cycle and the style of its take, mapped by random cosines.
    SmoothMovement movement;
    RowMatrix hidden(takes * framesOfTake, 4);
    for (int take = 0; take < takes; ++take) {
        const RowMatrix style = normals(1, 2);
        const double size = random.between(0.8, 1.2);
        movement.spans.push_back({take * framesOfTake, framesOfTake});
        for (Eigen::Index i = 0; i < framesOfTake; ++i) {
            const double phase =
                2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(framesOfTake);
            hidden.row(take * framesOfTake + i) << size * std::cos(phase), size * std::sin(phase),
                0.5 * style(0, 0), 0.3 * style(0, 1) * std::sin(2 * phase);
        }
    }
    RowMatrix arguments = 0.8 * hidden * normals(4, waves);
    for (Eigen::Index wave = 0; wave < waves; ++wave)
        arguments.col(wave).array() += random.between(0, 2 * std::numbers::pi);
    movement.rows = 0.05 * RowMatrix(arguments.array().cos()) * normals(waves, coordinates);
    movement.rows += noise * normals(hidden.rows(), coordinates);
    movement.rows.rowwise() -= movement.rows.colwise().mean().eval();
    return movement;
}

GpdmState randomState(Eigen::Index frames, int dimensions, std::uint64_t seed)
{
    Random random(seed);
    GpdmState state;
    state.latents = RowMatrix::NullaryExpr(frames, dimensions, [&random] { return random.normal(); });
    const auto parameter = [&random] { return std::exp(random.between(-1, 1)); };
    state.hyperparameters = {parameter(), parameter(), 10 * parameter(), parameter(),
                             parameter(), parameter(), 10 * parameter()};
    return state;
}

} // namespace quadrille::test
