// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/quality/liveliness.h"

#include "model/core/ranks.h"

#include <vector>

namespace quadrille {

Table<double> livelinessOf(std::span<const FrameMeasure> measures, const FrameLayout& layout)
{
    std::vector<std::vector<double>> accelerations(static_cast<std::size_t>(layout.sequenceCount()));
    for (NodeIndex node = 0; node < layout.frameCount(); ++node) {
        if (const auto& value = measures[static_cast<std::size_t>(node)].acceleration)
            accelerations[static_cast<std::size_t>(layout.sequenceOf(node))].push_back(*value);
    }
    Table<double> liveliness(layout.sequenceCount(), layout.sequenceCount());
    for (int a = 0; a < layout.sequenceCount(); ++a) {
        for (int b = 0; b <= a; ++b) {
            std::vector<double> both = accelerations[static_cast<std::size_t>(a)];
            const std::vector<double>& other = accelerations[static_cast<std::size_t>(b)];
            if (a != b)
                both.insert(both.end(), other.begin(), other.end());
            liveliness(a, b) = liveliness(b, a) = quantile(std::move(both), 0.95);
        }
    }
    return liveliness;
}

Table<float> costPerLiveliness(Table<float> cost, const FrameLayout& layout, const Table<double>& liveliness)
{
    std::vector<double> known;
    for (int a = 0; a < layout.sequenceCount(); ++a) {
        for (int b = 0; b <= a; ++b) {
            if (liveliness(a, b) > 0)
                known.push_back(liveliness(a, b));
        }
    }
    const double typical = quantile(std::move(known), 0.5);
    for (int a = 0; a < layout.sequenceCount(); ++a) {
        for (int b = 0; b < layout.sequenceCount(); ++b) {
            if (liveliness(a, b) > 0)
                cost.block(layout.firstOf(a), layout.firstOf(b), layout.countOf(a), layout.countOf(b)) *=
                    static_cast<float>(typical / liveliness(a, b));
        }
    }
    return cost;
}

} // namespace quadrille
