// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/transfererrors.h"

#include "model/geometry/procrustes.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

namespace {

VertexErrors errorsAfter(const Vec3d& shift, Positions made, Positions truth)
{
    VertexErrors errors;
    for (std::size_t v = 0; v < made.size(); ++v) {
        const double error = (made[v].cast<double>() + shift - truth[v].cast<double>()).norm();
        errors.mean += error / static_cast<double>(made.size());
        errors.worst = std::max(errors.worst, error);
    }
    return errors;
}

} // namespace

TransferErrors transferErrors(Positions made, Positions truth)
{
    assert(made.size() == truth.size() && !made.empty());
    return {.moved = errorsAfter(centroid(truth) - centroid(made), made, truth),
            .placed = errorsAfter(Vec3d::Zero(), made, truth)};
}

} // namespace quadrille
