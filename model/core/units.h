// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <compare>
#include <cstdint>
#include <functional>
#include <span>

namespace quadrille {

/// An index that cannot be confused with an index of another kind.
/// Conversion to and from integers is explicit.
template <typename Tag, typename Rep>
struct Index
{
    Rep value = 0;

    constexpr Index() = default;
    template <std::integral Integer>
    constexpr explicit Index(Integer v) : value(static_cast<Rep>(v))
    {
    }
    constexpr auto operator<=>(const Index&) const = default;
    constexpr Index& operator++()
    {
        ++value;
        return *this;
    }
};

/// Zero-based frame of a sequence.
using FrameIndex = Index<struct FrameTag, std::int64_t>;
/// Zero-based vertex of a topology.
using VertexIndex = Index<struct VertexTag, std::uint32_t>;
/// Zero-based triangle of a topology.
using TriangleIndex = Index<struct TriangleTag, std::uint32_t>;

struct Seconds
{
    double value = 0;
    constexpr auto operator<=>(const Seconds&) const = default;
};

/// Frames [first, last], both ends included; empty when last < first.
struct FrameRange
{
    FrameIndex first{0};
    FrameIndex last{-1};

    constexpr bool operator==(const FrameRange&) const = default;
    constexpr std::int64_t count() const { return last < first ? 0 : last.value - first.value + 1; }
    constexpr bool contains(FrameIndex f) const { return first <= f && f <= last; }
    static constexpr FrameRange all(std::int64_t frameCount)
    {
        return {FrameIndex(0), FrameIndex(frameCount - 1)};
    }
};

using Vec2f = Eigen::Vector2f;
using Vec2d = Eigen::Vector2d;
using Vec3f = Eigen::Vector3f;
using Vec3d = Eigen::Vector3d;

/// Vertex positions of one frame in vertex order, in the unit of whoever holds them: a project's sequences
/// and clips are in its own. Twelve bytes a vertex, contiguous.
using Positions = std::span<const Vec3f>;
using MutablePositions = std::span<Vec3f>;
static_assert(sizeof(Vec3f) == 12);

} // namespace quadrille

template <typename Tag, typename Rep>
struct std::hash<quadrille::Index<Tag, Rep>>
{
    std::size_t operator()(quadrille::Index<Tag, Rep> i) const noexcept { return std::hash<Rep>{}(i.value); }
};
