// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/feet.h"
#include "model/synthesis/clips/clip.h"
#include "model/synthesis/clips/ground.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace quadrille::test {

/// Horizontal speed, m/s, of the vertices of a foot that are at most 1 cm above its lowest in two frames, for
/// each step inside its contacts.
inline std::vector<double> footSkate(const Clip& clip, const Foot& foot,
                                     std::span<const ContactSpan> contacts, UpAxis up = UpAxis::Y)
{
    const Ground ground(up);
    const auto heightOf = [&](Positions pose, std::uint32_t v) {
        return ground.heightOf(pose[v].cast<double>());
    };
    const auto lowest = [&](Positions pose) {
        double low = std::numeric_limits<double>::max();
        for (const std::uint32_t v : foot.vertices)
            low = std::min(low, heightOf(pose, v));
        return low;
    };
    std::vector<double> speeds;
    for (const ContactSpan& contact : contacts) {
        if (contact.foot != foot.name)
            continue;
        for (std::int64_t f = contact.frames.first.value; f < contact.frames.last.value; ++f) {
            const Positions a = clip.frame(f);
            const Positions b = clip.frame(f + 1);
            double sum = 0;
            int count = 0;
            for (const std::uint32_t v : foot.vertices) {
                if (heightOf(a, v) > lowest(a) + 0.01 || heightOf(b, v) > lowest(b) + 0.01)
                    continue;
                sum += (ground.of(b[v].cast<double>()) - ground.of(a[v].cast<double>())).norm();
                ++count;
            }
            if (count > 0)
                speeds.push_back(sum / count * clip.fps);
        }
    }
    return speeds;
}

inline double meanOf(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value / static_cast<double>(values.size());
    return sum;
}

} // namespace quadrille::test
