// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace quadrille {

/// Values evened out along their order by a Gaussian. Beyond both ends they are continued
/// point-symmetrically: the ends stay as they are, straight lines stay straight, and what ascends still does.
/// Fewer than three values are not changed. It is cut off at three deviations.
/// \param deviation  standard deviation of the Gaussian, in steps; 0: nothing is changed. \pre deviation ≥ 0.
/// Cost: O(values · deviation).
template <typename Value>
std::vector<Value> evened(const std::vector<Value>& values, double deviation)
{
    const auto count = static_cast<std::int64_t>(values.size());
    const auto radius = static_cast<std::int64_t>(std::ceil(3 * deviation));
    if (radius == 0 || count < 3)
        return values;
    const std::int64_t period = 2 * (count - 1);
    const Value rise = 2.0 * (values.back() - values.front());
    const auto continued = [&](std::int64_t i) -> Value {
        const std::int64_t turns = i >= 0 ? i / period : -((period - 1 - i) / period);
        const std::int64_t within = i - turns * period;
        const auto turned = static_cast<double>(turns);
        if (within < count)
            return values[static_cast<std::size_t>(within)] + turned * rise;
        return 2.0 * values.back() - values[static_cast<std::size_t>(period - within)] + turned * rise;
    };
    std::vector<Value> result(values);
    for (std::int64_t i = 1; i + 1 < count; ++i) {
        Value sum = 0.0 * values.front();
        double weights = 0;
        for (std::int64_t d = -radius; d <= radius; ++d) {
            const double z = static_cast<double>(d) / deviation;
            const double weight = std::exp(-z * z / 2);
            sum += weight * continued(i + d);
            weights += weight;
        }
        result[static_cast<std::size_t>(i)] = sum / weights;
    }
    return result;
}

} // namespace quadrille
