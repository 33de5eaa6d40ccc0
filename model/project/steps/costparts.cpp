// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/costparts.h"

#include "model/synthesis/clips/stepcosts.h"

#include <algorithm>

namespace quadrille {

CostParts CostSplit::of(const Transition& transition, float drift, float cost) const
{
    CostParts parts;
    for (const auto& [i, j] : transition.path) {
        const auto pose = static_cast<double>(distances(i, j));
        const double feet = contactWeight * differingFeet(stances, i, j);
        parts.pose += pose;
        parts.contacts += feet;
        parts.velocity += std::max(static_cast<double>(step(i, j)) - pose - feet, 0.0);
    }
    parts.contacts += contactWeight / dragOfOneFoot * static_cast<double>(drift) * transition.length();
    // A mean, or in shares of liveliness.
    const double sum = parts.sum();
    const double scale = sum > 0 ? static_cast<double>(cost) / sum : 1;
    return {parts.pose * scale, parts.contacts * scale, parts.velocity * scale};
}

} // namespace quadrille
