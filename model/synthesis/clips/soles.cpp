// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/soles.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

Sole soleOf(Positions pose, std::span<const std::uint32_t> vertices, double figureHeight,
            const Ground& ground)
{
    const double reach = 0.02 * figureHeight;
    Sole sole;
    std::vector<double> heights;
    for (const std::uint32_t v : vertices) {
        const Vec3d p = pose[v].cast<double>();
        sole.places.push_back(ground.of(p));
        heights.push_back(ground.heightOf(p));
        sole.middle += sole.places.back() / static_cast<double>(vertices.size());
    }
    const double lowest = std::ranges::min(heights);
    double sum = 0;
    for (const double height : heights) {
        const double near = std::max(0.0, 1 - (height - lowest) / reach);
        sole.weights.push_back(near * near);
        sole.height += near * near * height;
        sum += near * near;
    }
    sole.height /= sum;
    return sole;
}

Touch touchOf(const Sole& before, const Sole& after, double figureHeight)
{
    const double slack = 0.01 * figureHeight;
    std::vector<double> weights(before.weights.size());
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = before.weights[i] * after.weights[i];
        sum += weights[i];
    }
    // A foot that rolls over within a frame has no vertex that touches in both.
    if (sum < 1e-3) {
        sum = 0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            weights[i] = before.weights[i] + after.weights[i];
            sum += weights[i];
        }
    }
    Touch touch;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        touch.before += weights[i] / sum * before.places[i];
        touch.after += weights[i] / sum * after.places[i];
    }
    // The turn of a small piece says little: it counts like one of the size of the slack that stays.
    double sine = 0;
    double cosine = slack * slack;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Vec2d a = before.places[i] - touch.before;
        const Vec2d b = after.places[i] - touch.after;
        sine += weights[i] / sum * (a.x() * b.y() - a.y() * b.x());
        cosine += weights[i] / sum * a.dot(b);
    }
    touch.turn = std::atan2(sine, cosine);
    return touch;
}

double soleSlip(Positions before, Positions after, std::span<const std::uint32_t> vertices,
                double figureHeight, const Ground& ground)
{
    const Touch touch = touchOf(soleOf(before, vertices, figureHeight, ground),
                                soleOf(after, vertices, figureHeight, ground), figureHeight);
    return (touch.after - touch.before).norm();
}

} // namespace quadrille
