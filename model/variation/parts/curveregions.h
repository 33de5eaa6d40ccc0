// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/geometry/vertextriangles.h"
#include "model/variation/parts/bodyparts.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace quadrille {

/// The pieces that some curves cut a surface into.
struct CurveRegions
{
    static constexpr int none = -1;

    int count = 0;
    /// Per triangle; `none` where nothing joins it to a curve.
    std::vector<int> ofTriangle;
    /// Per curve the regions on its left and right.
    std::vector<std::array<int, 2>> beside;
};

/// \pre Each curve is closed and separates; no two share a vertex.
CurveRegions curveRegions(const Topology& topology, const VertexTriangles& around,
                          std::span<const PartCurve> curves);

/// Which part of a tree lies in which region. Parts and curves as indices.
struct PartRegions
{
    /// What is wrong with a part.
    struct Fault
    {
        ErrorCode code;
        std::size_t part;
    };

    /// Per part the region that it shares with its parent; `none` for the root.
    std::vector<int> overlaps;
    /// Per part the curves of its overlap: the one towards the parent, the one towards the part.
    std::vector<std::array<std::size_t, 2>> curves;
    /// Per region the part that lies there alone; the child in overlaps.
    std::vector<int> partOf;
    std::vector<Fault> faults;
};

/// \param areas  per region; where a part alone hangs on the root, the greater piece is the root.
/// \pre The descriptions form a tree whose curves are all of `curves`.
PartRegions partRegions(const CurveRegions& regions, std::span<const PartCurve> curves,
                        std::span<const PartDescription> descriptions, std::span<const double> areas);

/// The parts that have no vertex beyond overlaps. \pre No faults.
std::vector<std::size_t> emptyParts(const Topology& topology, const CurveRegions& regions,
                                    const PartRegions& parts);

/// The curves that parts name.
std::vector<PartCurve> usedCurves(std::span<const PartCurve> curves,
                                  std::span<const PartDescription> descriptions);

/// The position of a name, or nothing.
template <typename Named>
std::optional<std::size_t> indexOf(std::span<const Named> things, const std::string& name)
{
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (things[i].name == name)
            return i;
    }
    return std::nullopt;
}

} // namespace quadrille
