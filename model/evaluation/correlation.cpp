// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/evaluation/correlation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <vector>

namespace quadrille {

namespace {

std::vector<double> centred(std::span<const double> values)
{
    std::vector<double> result(values.begin(), values.end());
    const double mean =
        std::accumulate(result.begin(), result.end(), 0.0) / static_cast<double>(result.size());
    for (double& value : result)
        value -= mean;
    return result;
}

double dot(const std::vector<double>& a, const std::vector<double>& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// A sample with what its table of differences |v_i − v_j| needs.
struct Sample
{
    std::vector<double> values; ///< centred
    std::vector<std::size_t> order;
    std::vector<double> rowSums; ///< Σ_j |v_i − v_j|
    double total = 0;            ///< Σ_ij |v_i − v_j|
    double squares = 0;          ///< Σ_ij |v_i − v_j|²

    explicit Sample(std::span<const double> sample)
        : values(centred(sample)), order(values.size()), rowSums(values.size())
    {
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
            return values[a] != values[b] ? values[a] < values[b] : a < b;
        });
        const auto n = static_cast<double>(values.size());
        const double sum = std::accumulate(values.begin(), values.end(), 0.0);
        double below = 0;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const double value = values[order[k]];
            rowSums[order[k]] = (2 * static_cast<double>(k) - n) * value + sum - 2 * below;
            below += value;
        }
        total = std::accumulate(rowSums.begin(), rowSums.end(), 0.0);
        squares = 2 * n * dot(values, values) - 2 * sum * sum;
    }
};

/// Sums over points, by the rank of their second coordinate (Fenwick tree).
class RankedSums
{
public:
    struct Sums
    {
        double count = 0;
        double x = 0;
        double y = 0;
        double xy = 0;

        void add(const Sums& other)
        {
            count += other.count;
            x += other.x;
            y += other.y;
            xy += other.xy;
        }
        /// Σ (a − x)(b − y) over the points.
        double products(double a, double b) const { return count * a * b - a * y - b * x + xy; }
    };

    explicit RankedSums(std::size_t size) : m_tree(size + 1) {}

    void add(std::size_t rank, const Sums& point)
    {
        for (std::size_t i = rank + 1; i < m_tree.size(); i += lowestBit(i))
            m_tree[i].add(point);
    }
    Sums below(std::size_t rank) const
    {
        Sums sums;
        for (std::size_t i = rank; i > 0; i -= lowestBit(i))
            sums.add(m_tree[i]);
        return sums;
    }

private:
    static std::size_t lowestBit(std::size_t i) { return i & (~i + 1); }
    std::vector<Sums> m_tree;
};

/// Σ_ij |x_i − x_j|·|y_i − y_j|
double sumOfProducts(const Sample& x, const Sample& y, const Progress& progress)
{
    const std::size_t n = x.values.size();
    std::vector<std::size_t> rank(n);
    for (std::size_t k = 0; k < n; ++k)
        rank[y.order[k]] = k;
    RankedSums ranked(n);
    RankedSums::Sums before;
    double sum = 0;
    constexpr std::size_t step = 65536;
    for (std::size_t k = 0; k < n; ++k) {
        if (k % step == 0)
            progress.report(static_cast<std::int64_t>(k), static_cast<std::int64_t>(n));
        const std::size_t i = x.order[k];
        const double a = x.values[i];
        const double b = y.values[i];
        // Those before have a smaller x; the product counts as negative where y is larger.
        sum += 2 * ranked.below(rank[i]).products(a, b) - before.products(a, b);
        const RankedSums::Sums point{1, a, b, a * b};
        ranked.add(rank[i], point);
        before.add(point);
    }
    return 2 * sum;
}

/// Mean product of the doubly centred tables of differences.
double covariance(double products, double rowProducts, double totals, double n)
{
    return products / (n * n) - 2 * rowProducts / (n * n * n) + totals / (n * n * n * n);
}

} // namespace

double pearsonCorrelation(std::span<const double> x, std::span<const double> y)
{
    assert(x.size() == y.size());
    if (x.empty())
        return 0;
    const std::vector<double> a = centred(x);
    const std::vector<double> b = centred(y);
    const double scale = std::sqrt(dot(a, a)) * std::sqrt(dot(b, b));
    return scale > 0 ? dot(a, b) / scale : 0;
}

double distanceCorrelation(std::span<const double> x, std::span<const double> y, const Progress& progress)
{
    assert(x.size() == y.size());
    if (x.empty())
        return 0;
    const Sample a(x);
    const Sample b(y);
    const auto n = static_cast<double>(x.size());
    const double products = sumOfProducts(a, b, progress);
    const double both = covariance(products, dot(a.rowSums, b.rowSums), a.total * b.total, n);
    const double ofA = covariance(a.squares, dot(a.rowSums, a.rowSums), a.total * a.total, n);
    const double ofB = covariance(b.squares, dot(b.rowSums, b.rowSums), b.total * b.total, n);
    if (!(ofA > 0) || !(ofB > 0))
        return 0;
    return std::sqrt(std::clamp(both / std::sqrt(ofA * ofB), 0.0, 1.0));
}

} // namespace quadrille
