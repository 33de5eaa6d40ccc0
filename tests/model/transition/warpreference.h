// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/table.h"
#include "model/transition/framelayout.h"
#include "model/transition/transitionsettings.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace quadrille {

/// Plain computation of one transition: every window of destinations has a dynamic programme of its own, in
/// double precision, which is read where each window of sources ends. Each state of a cell keeps the least
/// (sum, cells) in that order.
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
        const int shortest = m_settings.shortest();
        std::optional<Best> best;
        for (int lj = shortest; rows >= shortest && lj <= columns; ++lj) {
            const bool isSum = m_settings.cost == TransitionCost::Sum;
            if (isSum)
                findSums(i, j, rows, lj);
            else
                findSumsOfAllLengths(i, j, rows, lj);
            for (int li = shortest; li <= rows; ++li) {
                const Best found = isSum ? leastSum(li, lj) : leastMean(rows, li, lj);
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
    static constexpr double none = std::numeric_limits<double>::infinity();

    /// Of equals the one with the shorter source window, then with the shorter destination window.
    bool isBetter(const Best& a, const Best& b) const
    {
        const bool mean = m_settings.cost == TransitionCost::Mean;
        const double costA = mean ? a.sum * b.length : a.sum;
        const double costB = mean ? b.sum * a.length : b.sum;
        return std::tie(costA, a.length, a.sourceWindow, a.destinationWindow) <
               std::tie(costB, b.length, b.sourceWindow, b.destinationWindow);
    }

    static Value better(const Value& a, const Value& b)
    {
        return b.sum < a.sum || (b.sum == a.sum && b.length < a.length) ? b : a;
    }

    int states() const { return 1 + 2 * m_settings.slope; }

    Value& valueAt(int a, int b, int s, int lj)
    {
        return m_values[static_cast<std::size_t>((a * lj + b) * states() + s)];
    }

    void findSums(NodeIndex i, NodeIndex j, int li, int lj)
    {
        const int slope = m_settings.slope;
        m_values.assign(static_cast<std::size_t>(li * lj * states()), Value());
        const auto at = [&](int a, int b, int s) -> Value& { return valueAt(a, b, s, lj); };
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
    }

    Best leastSum(int li, int lj)
    {
        Value best;
        for (int s = 0; s < states(); ++s)
            best = better(best, valueAt(li - 1, lj - 1, s, lj));
        return {best.sum, best.length, li, lj};
    }

    /// The least sums for every number of cells that a path to the place can have.
    double* sumsAt(int a, int b, int s, int li, int lj)
    {
        return m_sums.data() + static_cast<std::ptrdiff_t>((a * lj + b) * states() + s) * (li + lj);
    }

    void findSumsOfAllLengths(NodeIndex i, NodeIndex j, int li, int lj)
    {
        const int slope = m_settings.slope;
        m_sums.assign(static_cast<std::size_t>(li * lj * states() * (li + lj)), none);
        const auto at = [&](int a, int b, int s) { return sumsAt(a, b, s, li, lj); };
        for (int a = 0; a < li; ++a) {
            for (int b = 0; b < lj; ++b) {
                const double d = m_distances(i + a, j - lj + 1 + b);
                const auto extend = [d, most = a + b + 1](double* to, const double* from) {
                    for (int n = 1; n < most; ++n)
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
    }

    /// The least mean is sought among the least sums for every number of cells.
    /// \param rows of the sums found.
    Best leastMean(int rows, int li, int lj)
    {
        Best best;
        for (int n = 1; n < li + lj; ++n) {
            for (int s = 0; s < states(); ++s) {
                const Best found{sumsAt(li - 1, lj - 1, s, rows, lj)[n], n, li, lj};
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
