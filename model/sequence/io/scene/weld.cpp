// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/weld.h"

#include <algorithm>
#include <numeric>

namespace quadrille {

std::uint32_t RowClasses::classOf(std::string row)
{
    return m_classes.try_emplace(std::move(row), static_cast<std::uint32_t>(m_classes.size())).first->second;
}

namespace {

class DisjointSets
{
public:
    explicit DisjointSets(std::size_t count) : m_parents(count)
    {
        std::iota(m_parents.begin(), m_parents.end(), 0U);
    }
    std::uint32_t root(std::uint32_t i)
    {
        while (m_parents[i] != i)
            i = m_parents[i] = m_parents[m_parents[i]];
        return i;
    }
    /// The smaller index stays the root.
    void join(std::uint32_t a, std::uint32_t b)
    {
        a = root(a);
        b = root(b);
        m_parents[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parents;
};

/// Vertices of one place and one attribute class.
std::vector<std::uint32_t> placeClasses(std::span<const Vec3f> positions,
                                        std::span<const std::uint32_t> attributeClasses)
{
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t v) {
        const Vec3f& p = positions[v];
        return std::array{p.x(), p.y(), p.z()};
    };
    const auto attribute = [&](std::uint32_t v) {
        return attributeClasses.empty() ? 0U : attributeClasses[v];
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto ka = key(a);
        const auto kb = key(b);
        return ka != kb ? ka < kb : attribute(a) < attribute(b);
    });
    std::vector<std::uint32_t> classes(positions.size());
    std::uint32_t current = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i > 0 && (key(order[i]) != key(order[i - 1]) || attribute(order[i]) != attribute(order[i - 1])))
            ++current;
        classes[order[i]] = current;
    }
    return classes;
}

constexpr std::size_t maxSidesOfEdge = 64;

/// One side of one triangle; `low` and `high` are its ends by class.
struct Side
{
    std::uint32_t lowClass;
    std::uint32_t highClass;
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t oppositeClass;
    bool forward; ///< the triangle runs from low to high
    bool taken = false;
};

std::vector<Side> sortedSides(std::span<const std::array<std::uint32_t, 3>> triangles,
                              const std::vector<std::uint32_t>& classes)
{
    std::vector<Side> sides;
    sides.reserve(triangles.size() * 3);
    for (const auto& triangle : triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t from = triangle[c];
            const std::uint32_t to = triangle[(c + 1) % 3];
            const std::uint32_t opposite = classes[triangle[(c + 2) % 3]];
            if (classes[from] < classes[to])
                sides.push_back({classes[from], classes[to], from, to, opposite, true});
            else if (classes[to] < classes[from])
                sides.push_back({classes[to], classes[from], to, from, opposite, false});
        }
    }
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return a.lowClass != b.lowClass ? a.lowClass < b.lowClass : a.highClass < b.highClass;
    });
    return sides;
}

/// Pairs the sides that lie on one edge: those that share vertices first, then the rest in file order.
void joinSides(std::span<Side> sides, DisjointSets& sets)
{
    const auto pairUp = [&](auto&& fits) {
        for (Side& a : sides) {
            if (a.taken || !a.forward)
                continue;
            const auto b = std::find_if(sides.begin(), sides.end(), [&](const Side& candidate) {
                return !candidate.taken && !candidate.forward && fits(a, candidate);
            });
            if (b == sides.end())
                continue;
            a.taken = b->taken = true;
            sets.join(a.low, b->low);
            sets.join(a.high, b->high);
        }
    };
    pairUp([](const Side& a, const Side& b) { return a.low == b.low && a.high == b.high; });
    pairUp([](const Side& a, const Side& b) { return a.oppositeClass != b.oppositeClass; });
}

} // namespace

Weld weldVertices(std::span<const Vec3f> positions, std::span<const std::uint32_t> attributeClasses,
                  std::span<const std::array<std::uint32_t, 3>> triangles)
{
    auto sides = sortedSides(triangles, placeClasses(positions, attributeClasses));
    DisjointSets sets(positions.size());
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].lowClass == sides[i].lowClass &&
               sides[end].highClass == sides[i].highClass)
            ++end;
        if (end - i <= maxSidesOfEdge)
            joinSides(std::span(sides).subspan(i, end - i), sets);
        i = end;
    }
    Weld weld;
    weld.vertexOf.resize(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        const std::uint32_t root = sets.root(v);
        if (root == v) {
            weld.vertexOf[v] = weld.vertexCount();
            weld.firstOf.push_back(v);
        } else {
            weld.vertexOf[v] = weld.vertexOf[root];
        }
    }
    return weld;
}

} // namespace quadrille
