// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/indices.h"
#include "model/geometry/trianglelogs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace quadrille {

namespace {

Vec3d axisOf(const TriangleLogs& logs, std::size_t m)
{
    return {logs.axisX[m], logs.axisY[m], logs.axisZ[m]};
}

/// The rotations as unit quaternions w, x, y, z with w ≥ 0, side by side.
using Quaternions = std::vector<std::array<double, 4>>;

Quaternions quaternionsOf(const TriangleLogs& logs)
{
    Quaternions quaternions(logs.size());
    for (std::size_t m = 0; m < quaternions.size(); ++m) {
        const double cosine = logs.cosine[m];
        const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        quaternions[m] = {cosine, sine * logs.axisX[m], sine * logs.axisY[m], sine * logs.axisZ[m]};
    }
    return quaternions;
}

/// Of two rotations the cosine of half the angle between them, negative where the short way from one to the
/// other leads over 180 degrees.
double likeness(const std::array<double, 4>& a, const std::array<double, 4>& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

bool allFit(const PoissonSystem& system, const Quaternions& turns)
{
    return std::none_of(system.dualEdges().begin(), system.dualEdges().end(),
                        [&](const PoissonSystem::DualEdge& edge) {
                            return likeness(turns[at(edge[0])], turns[at(edge[1])]) < 0;
                        });
}

/// Whether all rotations turn by less than 90 degrees; then any two fit.
bool allTurnLittle(const TriangleLogs& logs)
{
    return std::none_of(logs.cosine.begin(), logs.cosine.end(),
                        [](double cosine) { return cosine < std::numbers::sqrt2 / 2; });
}

/// Of the two ways round to a rotation the one nearest to the turn of a neighbour.
void fitToNeighbour(TriangleLogs& logs, std::size_t neighbour, std::size_t m)
{
    const double turned = logs.halfAngle[neighbour];
    if (logs.halfAngle[m] < 1e-9) {
        // Next to no rotation has any axis, should it be a whole turn.
        if (std::abs(turned) > std::numbers::pi / 2) {
            logs.axisX[m] = logs.axisX[neighbour];
            logs.axisY[m] = logs.axisY[neighbour];
            logs.axisZ[m] = logs.axisZ[neighbour];
            logs.halfAngle[m] = std::copysign(std::numbers::pi, turned);
        }
        return;
    }
    if (axisOf(logs, m).dot(axisOf(logs, neighbour)) * turned < logs.halfAngle[m] - std::numbers::pi / 2)
        logs.halfAngle[m] -= std::numbers::pi;
}

/// Edges to grow over, those with the least difference first; among equals the one seen last.
class Frontier
{
public:
    struct Step
    {
        int from;
        int to;
    };

    /// \param likeness  in [0, 1].
    void push(Step step, double likeness)
    {
        const double angle = std::sqrt(std::max(0.0, 1 - likeness));
        const auto bucket = static_cast<std::size_t>(angle * (bucketCount - 1));
        m_buckets[std::min(bucket, m_buckets.size() - 1)].push_back(step);
        m_first = std::min(m_first, bucket);
    }
    bool pop(Step& step)
    {
        while (m_first < m_buckets.size() && m_buckets[m_first].empty())
            ++m_first;
        if (m_first >= m_buckets.size())
            return false;
        step = m_buckets[m_first].back();
        m_buckets[m_first].pop_back();
        return true;
    }

private:
    static constexpr int bucketCount = 16;
    std::vector<std::vector<Step>> m_buckets{bucketCount};
    std::size_t m_first = bucketCount;
};

} // namespace

void chooseBranches(const PoissonSystem& system, TriangleLogs& logs)
{
    if (allTurnLittle(logs))
        return;
    const Quaternions turns = quaternionsOf(logs);
    if (allFit(system, turns))
        return;
    std::vector<bool> done(logs.size(), false);
    Frontier frontier;
    const auto grow = [&](int m) {
        done[at(m)] = true;
        for (int n = system.neighbourStarts()[at(m)]; n < system.neighbourStarts()[at(m) + 1]; ++n) {
            const int neighbour = system.neighbours()[at(n)];
            if (!done[at(neighbour)])
                frontier.push({m, neighbour}, std::abs(likeness(turns[at(m)], turns[at(neighbour)])));
        }
    };
    const auto growFrom = [&](int seed) {
        if (done[at(seed)])
            return;
        grow(seed);
        for (Frontier::Step step{}; frontier.pop(step);) {
            if (done[at(step.to)])
                continue;
            fitToNeighbour(logs, at(step.from), at(step.to));
            grow(step.to);
        }
    };
    const auto least = std::max_element(logs.cosine.begin(), logs.cosine.end());
    growFrom(static_cast<int>(least - logs.cosine.begin()));
    // The other connected parts, each from the triangle that turns least.
    std::vector<int> left;
    for (int m = 0; m < static_cast<int>(logs.size()); ++m) {
        if (!done[at(m)])
            left.push_back(m);
    }
    std::stable_sort(left.begin(), left.end(),
                     [&](int a, int b) { return logs.cosine[at(a)] > logs.cosine[at(b)]; });
    for (const int seed : left)
        growFrom(seed);
}

void borrowRotations(const PoissonSystem& system, std::span<const int> triangles, TriangleLogs& logs)
{
    std::vector<bool> waits(logs.size(), false);
    for (const int m : triangles) {
        waits[at(m)] = true;
        logs.axisX[at(m)] = logs.axisY[at(m)] = logs.axisZ[at(m)] = logs.halfAngle[at(m)] = 0;
        logs.cosine[at(m)] = 1;
        logs.logScale[at(m)] = logs.logStretch[at(m)] = logs.u1[at(m)] = logs.u2[at(m)] = 0;
    }
    // Each round reaches the triangles next to those that the rounds before have reached.
    std::vector<int> left(triangles.begin(), triangles.end());
    for (std::size_t before = left.size() + 1; !left.empty() && left.size() < before;) {
        before = left.size();
        std::vector<int> reached;
        for (const int m : left) {
            const auto begin = system.neighbours().begin() + system.neighbourStarts()[at(m)];
            const auto end = system.neighbours().begin() + system.neighbourStarts()[at(m) + 1];
            const auto found = std::find_if(begin, end, [&](int n) { return !waits[at(n)]; });
            if (found == end)
                continue;
            const std::size_t n = at(*found);
            logs.axisX[at(m)] = logs.axisX[n];
            logs.axisY[at(m)] = logs.axisY[n];
            logs.axisZ[at(m)] = logs.axisZ[n];
            logs.halfAngle[at(m)] = logs.halfAngle[n];
            logs.cosine[at(m)] = logs.cosine[n];
            reached.push_back(m);
        }
        for (const int m : reached)
            waits[at(m)] = false;
        std::erase_if(left, [&](int m) { return !waits[at(m)]; });
    }
}

} // namespace quadrille
