// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/framelayout.h"
#include "model/transition/transitionsettings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace quadrille {

/// Plain computation of one transition: every pair of windows has a dynamic programme of its own, in double
/// precision. Each state of a cell keeps the least (sum, cells) in that order.
class WarpReference
{
public:
    struct Best
    {
        double sum = std::numeric_limits<double>::infinity();
        int length = 0;
        int sourceWindow = 0;
        int destinationWindow = 0;
    };

    WarpReference(const Table<float>& distances, const FrameLayout& layout,
                  const TransitionSettings& settings)
        : m_distances(distances), m_layout(layout), m_settings(settings)
    {
    }

    /// Nothing where no windows fit, or i = j.
    std::optional<Best> find(NodeIndex i, NodeIndex j)
    {
        if (i == j)
            return std::nullopt;
        const int rows = std::min(m_settings.longest(), m_layout.lastOf(m_layout.sequenceOf(i)) - i + 1);
        const int columns = std::min(m_settings.longest(), j - m_layout.firstOf(m_layout.sequenceOf(j)) + 1);
        std::optional<Best> best;
        for (int li = m_settings.shortest(); li <= rows; ++li) {
            for (int lj = m_settings.shortest(); lj <= columns; ++lj) {
                const Best found =
                    m_settings.cost == TransitionCost::Sum ? leastSum(i, j, li, lj) : leastMean(i, j, li, lj);
                if (found.length > 0 && (!best || isBetter(found, *best)))
                    best = found;
            }
        }
        return best;
    }

private:
    struct Value
    {
        double sum = std::numeric_limits<double>::infinity();
        int length = 0;
    };

    bool isBetter(const Best& a, const Best& b) const
    {
        const bool mean = m_settings.cost == TransitionCost::Mean;
        const double costA = mean ? a.sum * b.length : a.sum;
        const double costB = mean ? b.sum * a.length : b.sum;
        return costA < costB || (costA == costB && a.length < b.length);
    }

    static Value better(const Value& a, const Value& b)
    {
        return b.sum < a.sum || (b.sum == a.sum && b.length < a.length) ? b : a;
    }

    int states() const { return 1 + 2 * m_settings.slope; }

    Best leastSum(NodeIndex i, NodeIndex j, int li, int lj)
    {
        const int slope = m_settings.slope;
        m_values.assign(static_cast<std::size_t>(li * lj * states()), Value());
        const auto at = [&](int a, int b, int s) -> Value& {
            return m_values[static_cast<std::size_t>((a * lj + b) * states() + s)];
        };
        for (int a = 0; a < li; ++a) {
            for (int b = 0; b < lj; ++b) {
                const double d = m_distances(i + a, j - lj + 1 + b);
                const auto extend = [d](Value& to, const Value& from) {
                    if (from.length > 0)
                        to = better(to, {from.sum + d, from.length + 1});
                };
                if (a == 0 && b == 0)
                    at(0, 0, 0) = {d, 1};
                if (a > 0 && b > 0) {
                    for (int s = 0; s < states(); ++s)
                        extend(at(a, b, 0), at(a - 1, b - 1, s));
                }
                if (a > 0) {
                    extend(at(a, b, 1), at(a - 1, b, 0));
                    for (int s = 1; s <= slope; ++s)
                        extend(at(a, b, 1), at(a - 1, b, slope + s));
                    for (int s = 2; s <= slope; ++s)
                        extend(at(a, b, s), at(a - 1, b, s - 1));
                }
                if (b > 0) {
                    extend(at(a, b, slope + 1), at(a, b - 1, 0));
                    for (int s = 1; s <= slope; ++s)
                        extend(at(a, b, slope + 1), at(a, b - 1, s));
                    for (int s = 2; s <= slope; ++s)
                        extend(at(a, b, slope + s), at(a, b - 1, slope + s - 1));
                }
            }
        }
        Value best;
        for (int s = 0; s < states(); ++s)
            best = better(best, at(li - 1, lj - 1, s));
        return {best.sum, best.length, li, lj};
    }

    /// The least mean is sought among the least sums for every number of cells.
    Best leastMean(NodeIndex i, NodeIndex j, int li, int lj)
    {
        constexpr double none = std::numeric_limits<double>::infinity();
        const int slope = m_settings.slope;
        const int lengths = li + lj;
        m_sums.assign(static_cast<std::size_t>(li * lj * states() * lengths), none);
        const auto at = [&](int a, int b, int s) {
            return m_sums.data() + static_cast<std::ptrdiff_t>((a * lj + b) * states() + s) * lengths;
        };
        for (int a = 0; a < li; ++a) {
            for (int b = 0; b < lj; ++b) {
                const double d = m_distances(i + a, j - lj + 1 + b);
                const auto extend = [d, lengths](double* to, const double* from) {
                    for (int n = 1; n + 1 < lengths; ++n)
                        to[n + 1] = std::min(to[n + 1], from[n] + d);
                };
                if (a == 0 && b == 0)
                    at(0, 0, 0)[1] = d;
                for (int s = 0; a > 0 && b > 0 && s < states(); ++s)
                    extend(at(a, b, 0), at(a - 1, b - 1, s));
                if (a > 0) {
                    extend(at(a, b, 1), at(a - 1, b, 0));
                    for (int s = 1; s <= slope; ++s)
                        extend(at(a, b, 1), at(a - 1, b, slope + s));
                    for (int s = 2; s <= slope; ++s)
                        extend(at(a, b, s), at(a - 1, b, s - 1));
                }
                if (b > 0) {
                    extend(at(a, b, slope + 1), at(a, b - 1, 0));
                    for (int s = 1; s <= slope; ++s)
                        extend(at(a, b, slope + 1), at(a, b - 1, s));
                    for (int s = 2; s <= slope; ++s)
                        extend(at(a, b, slope + s), at(a, b - 1, slope + s - 1));
                }
            }
        }
        Best best;
        for (int n = 1; n < lengths; ++n) {
            for (int s = 0; s < states(); ++s) {
                const Best found{at(li - 1, lj - 1, s)[n], n, li, lj};
                if (found.sum < none && (best.length == 0 || isBetter(found, best)))
                    best = found;
            }
        }
        return best;
    }

    const Table<float>& m_distances;
    const FrameLayout& m_layout;
    const TransitionSettings& m_settings;
    std::vector<Value> m_values;
    std::vector<double> m_sums;
};

} // namespace quadrille
