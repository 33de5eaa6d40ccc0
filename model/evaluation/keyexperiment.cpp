// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/keyexperiment.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace quadrille {

std::vector<NodeIndex> connectedFrames(const Digraph& graph, std::span<const WalkSpan> spans)
{
    const Connectivity reach = connectivity(graph);
    std::vector<NodeIndex> frames;
    if (reach.components.empty() || reach.components.front().size() < 2)
        return frames;
    for (const NodeIndex node : reach.components.front()) {
        if (std::any_of(spans.begin(), spans.end(),
                        [node](const WalkSpan& span) { return node >= span.first && node <= span.last; }))
            frames.push_back(node);
    }
    return frames;
}

std::vector<PoseKey> drawKeys(std::vector<NodeIndex> pool, int count, std::int64_t duration,
                              std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    const auto unit = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    const auto keyCount = std::min(static_cast<std::size_t>(count), pool.size());
    std::vector<double> times(keyCount);
    for (std::size_t k = 0; k < keyCount; ++k) {
        std::swap(pool[k], pool[k + random() % (pool.size() - k)]);
        times[k] = k == 0 ? 0 : times[k - 1] + 0.25 + unit();
    }
    std::vector<PoseKey> keys;
    keys.reserve(keyCount);
    for (std::size_t k = 0; k < keyCount; ++k) {
        const double part = times.back() > 0 ? times[k] / times.back() : 0;
        keys.push_back({.frame = pool[k], .time = std::round(part * static_cast<double>(duration))});
    }
    return keys;
}

} // namespace quadrille
