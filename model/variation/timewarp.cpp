// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/variation/timewarp.h"

#include "model/core/smoothing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace quadrille {

namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();

/// The programme over costs: the state of a cell is the step that led to it, and how many of its kind there
/// were in a row: 0 is the diagonal, 1 … run steps along the reference, run + 1 … 2·run along the take.
class WarpProgramme
{
public:
    WarpProgramme(const Table<float>& costs, int run, bool unlimited, bool within)
        : m_costs(costs)
        , m_run(run)
        , m_unlimited(unlimited)
        , m_states(static_cast<std::size_t>(2) * static_cast<std::size_t>(run) + 1)
        , m_from(static_cast<std::size_t>(costs.size()) * m_states, noState)
    {
        const auto columns = static_cast<std::size_t>(costs.cols());
        Row above(columns, m_states);
        Row row(columns, m_states);
        for (Eigen::Index r = 0; r < costs.rows(); ++r) {
            std::swap(above, row);
            for (Eigen::Index c = 0; c < costs.cols(); ++c)
                enter(r, c, above, row, r == 0 && (within || c == 0));
        }
        m_last = std::move(row.sums);
    }

    /// The cheapest of the last row's cells, from one column on; nothing where none can be reached.
    std::optional<WarpPathResult> best(Eigen::Index firstColumn) const
    {
        std::size_t end = 0;
        double least = unreachable;
        for (std::size_t i = static_cast<std::size_t>(firstColumn) * m_states; i < m_last.size(); ++i) {
            if (m_last[i] < least) {
                least = m_last[i];
                end = i;
            }
        }
        if (least == unreachable)
            return std::nullopt;
        return trace(end, least);
    }

private:
    static constexpr std::uint8_t noState = 255;
    static constexpr std::uint8_t start = 254;

    /// The cheapest of some states of a cell; the first of equal ones.
    struct Least
    {
        double sum = unreachable;
        std::uint8_t state = noState;
    };
    struct Cell
    {
        Least any;
        Least notAlong;  ///< not by a step along the reference
        Least notAcross; ///< not by a step along the take
    };

    std::size_t cell(Eigen::Index r, Eigen::Index c) const
    {
        return static_cast<std::size_t>(r * m_costs.cols() + c) * m_states;
    }

    struct Row
    {
        std::vector<Cell> cells;
        std::vector<double> sums; ///< cells × states

        Row(std::size_t columns, std::size_t states) : cells(columns), sums(columns * states) {}
    };

    void enter(Eigen::Index r, Eigen::Index column, const Row& above, Row& row, bool isStart)
    {
        const auto c = static_cast<std::size_t>(column);
        double* const here = &row.sums[c * m_states];
        std::uint8_t* const from = &m_from[cell(r, column)];
        const Least corner = r > 0 && c > 0 ? above.cells[c - 1].any : Least();
        here[0] = isStart ? 0 : corner.sum;
        from[0] = isStart ? start : corner.state;
        std::fill_n(here + 1, m_states - 1, unreachable);
        if (r > 0) {
            const Cell& neighbour = above.cells[c];
            goStraight(m_unlimited ? neighbour.any : neighbour.notAlong, &above.sums[c * m_states], 1, here,
                       from);
        }
        if (c > 0) {
            const Cell& neighbour = row.cells[c - 1];
            goStraight(m_unlimited ? neighbour.any : neighbour.notAcross, here - m_states, m_run + 1, here,
                       from);
        }
        const double cost = m_costs(r, column);
        std::for_each_n(here, m_states, [cost](double& sum) { sum += cost; });
        row.cells[c] = summary(here);
    }

    /// Steps of one kind, whose states begin with `first`: the first in a row behind another kind, the others
    /// one behind the other.
    void goStraight(const Least& turn, const double* sums, int first, double* out, std::uint8_t* from) const
    {
        out[first] = turn.sum;
        from[first] = turn.state;
        for (int state = first + 1; state < first + m_run; ++state) {
            out[state] = sums[state - 1];
            from[state] = static_cast<std::uint8_t>(state - 1);
        }
    }

    Cell summary(const double* sums) const
    {
        const auto least = [sums](int from, int to, Least best) {
            for (int state = from; state < to; ++state) {
                if (sums[state] < best.sum)
                    best = {sums[state], static_cast<std::uint8_t>(state)};
            }
            return best;
        };
        const Least diagonal = least(0, 1, {});
        const Least notAcross = least(1, m_run + 1, diagonal);
        const int states = 2 * m_run + 1;
        return {.any = least(m_run + 1, states, notAcross),
                .notAlong = least(m_run + 1, states, diagonal),
                .notAcross = notAcross};
    }

    WarpPathResult trace(std::size_t end, double cost) const
    {
        WarpPathResult result{.path = {}, .cost = cost};
        auto r = static_cast<int>(m_costs.rows()) - 1;
        auto c = static_cast<int>(end / m_states);
        auto state = static_cast<std::uint8_t>(end % m_states);
        while (state != start) {
            result.path.push_back({r, c});
            const std::uint8_t from = m_from[cell(r, c) + state];
            if (from != start) {
                r -= state <= m_run ? 1 : 0;
                c -= state == 0 || state > m_run ? 1 : 0;
            }
            state = from;
        }
        std::reverse(result.path.begin(), result.path.end());
        return result;
    }

    const Table<float>& m_costs;
    int m_run;
    bool m_unlimited;
    std::size_t m_states;
    std::vector<std::uint8_t> m_from; ///< cells × states: the state of the cell before
    std::vector<double> m_last;       ///< columns × states: sums of the last row
};

/// The matched points of both times that the cells of a path mean, strictly ascending in both.
std::vector<Vec2d> anchorsOf(const std::vector<WarpMatch>& path)
{
    std::vector<Vec2d> anchors;
    const Vec2d first(path.front().reference, path.front().take);
    const Vec2d last(path.back().reference, path.back().take);
    for (std::size_t i = 0; i < path.size();) {
        const auto runs = [&](auto same) {
            std::size_t end = i + 1;
            while (end < path.size() && same(path[end], path[i]))
                ++end;
            return end;
        };
        const std::size_t across =
            runs([](const WarpMatch& a, const WarpMatch& b) { return a.reference == b.reference; });
        const std::size_t along =
            runs([](const WarpMatch& a, const WarpMatch& b) { return a.take == b.take; });
        const std::size_t end = std::max(across, along);
        const Vec2d middle =
            (Vec2d(path[i].reference, path[i].take) + Vec2d(path[end - 1].reference, path[end - 1].take)) / 2;
        if ((middle.array() > first.array()).all() && (middle.array() < last.array()).all())
            anchors.push_back(middle);
        // The last cell of a run may be the first of one of the other kind.
        const bool turns =
            end - i > 1 && end < path.size() &&
            (path[end].take == path[end - 1].take || path[end].reference == path[end - 1].reference);
        i = turns ? end - 1 : end;
    }
    anchors.insert(anchors.begin(), first);
    if (last != first)
        anchors.push_back(last);
    return anchors;
}

} // namespace

std::vector<double> takeSteps(const TakeWarp& warp, std::size_t referenceFrames)
{
    constexpr double leastStep = 0.05; // what hardly passes has no speed
    std::vector<double> steps(referenceFrames, 1);
    for (std::size_t r = 1; r < std::min(referenceFrames, warp.positions.size()); ++r)
        steps[r] = std::max(warp.positions[r] - warp.positions[r - 1], leastStep);
    if (referenceFrames > 1)
        steps[0] = steps[1];
    return steps;
}

WarpPathResult warpWhole(const Table<float>& costs, const WarpSteps& steps)
{
    assert(costs.rows() > 0 && costs.cols() > 0);
    const auto longer = std::max(costs.rows(), costs.cols());
    const auto shorter = std::min(costs.rows(), costs.cols());
    const auto needed = static_cast<int>((longer + shorter - 1) / shorter) - 1;
    const int longest = steps.longestRun <= 0 ? 0 : std::max(steps.longestRun, needed);
    const bool unlimited = longest == 0 || longest > WarpSteps::greatestRun;
    const int run = unlimited ? 1 : longest;
    return *WarpProgramme(costs, run, unlimited, false).best(costs.cols() - 1);
}

std::optional<WarpPathResult> warpWithin(const Table<float>& costs, const WarpSteps& steps)
{
    assert(costs.rows() > 0 && costs.cols() > 0);
    const bool unlimited = steps.longestRun <= 0 || steps.longestRun > WarpSteps::greatestRun;
    return WarpProgramme(costs, unlimited ? 1 : steps.longestRun, unlimited, true).best(0);
}

TakeWarp warpOf(const std::vector<WarpMatch>& path, double smoothing, FrameIndex first)
{
    const std::vector<Vec2d> anchors = anchorsOf(path);
    const int base = path.front().reference;
    std::vector<double> positions;
    std::size_t next = 1;
    for (int r = base; r <= path.back().reference; ++r) {
        while (next + 1 < anchors.size() && anchors[next].x() < r)
            ++next;
        const Vec2d& a = anchors[std::min(next, anchors.size() - 1) - (anchors.size() > 1 ? 1 : 0)];
        const Vec2d& b = anchors[std::min(next, anchors.size() - 1)];
        const double share = b.x() > a.x() ? (r - a.x()) / (b.x() - a.x()) : 0;
        positions.push_back(static_cast<double>(first.value) + a.y() + share * (b.y() - a.y()));
    }
    TakeWarp warp{
        .frames = {FrameIndex(first.value + path.front().take), FrameIndex(first.value + path.back().take)},
        .positions = evened(positions, smoothing),
        .playback = {}};
    warp.playback =
        inverseWarp(warp.positions, static_cast<double>(warp.frames.first.value), warp.frames.count());
    return warp;
}

TakeWarp blendedWarp(std::span<const WarpShare> warps)
{
    std::vector<WarpShare> some;
    std::ranges::copy_if(warps, std::back_inserter(some), [](const WarpShare& of) { return of.share > 0; });
    assert(!some.empty());
    if (some.size() == 1)
        return *some.front().warp;
    double length = 0;
    std::vector<double> positions(some.front().warp->positions.size());
    for (const auto& [warp, share] : some) {
        assert(warp->positions.size() == positions.size());
        length += share * static_cast<double>(warp->frames.count() - 1);
        for (std::size_t i = 0; i < positions.size(); ++i)
            positions[i] += share * (warp->positions[i] - static_cast<double>(warp->frames.first.value));
    }
    const double frames = std::max(1.0, std::round(length));
    for (double& position : positions)
        position = length > 0 ? position * frames / length : position;
    TakeWarp blend{.frames = FrameRange::all(static_cast<std::int64_t>(frames) + 1),
                   .positions = std::move(positions),
                   .playback = {}};
    blend.playback = inverseWarp(blend.positions, 0, blend.frames.count());
    return blend;
}

TakeWarp blendedWarp(const TakeWarp& a, const TakeWarp& b, double weight)
{
    return blendedWarp(std::array{WarpShare{&a, 1 - weight}, WarpShare{&b, weight}});
}

std::vector<double> inverseWarp(const std::vector<double>& positions, double first, std::int64_t count)
{
    std::vector<double> inverse;
    std::size_t next = 1;
    for (std::int64_t k = 0; k < count; ++k) {
        const double wanted = first + static_cast<double>(k);
        while (next + 1 < positions.size() && positions[next] < wanted)
            ++next;
        const double from = positions[next - 1];
        const double to = positions[next];
        const double share = to > from ? std::clamp((wanted - from) / (to - from), 0.0, 1.0) : 0;
        inverse.push_back(static_cast<double>(next - 1) + share);
    }
    return inverse;
}

} // namespace quadrille
