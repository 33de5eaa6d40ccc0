// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "resources/sample/maker/bodymesh.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille {

/// A part of the surface that is laid flat as one piece.
struct ChartLabels
{
    std::vector<std::string> names;
    std::vector<std::uint16_t> ofTriangle;
};

/// Cuts a body's surface into pieces like a tailor: front and back of torso, arms, legs and head, palm and
/// back of the hands, soles and sides of the shoes. Every chart is connected.
ChartLabels cutCharts(const SurfaceMesh& mesh, const Body& body);

/// A chart laid flat: as few distortions as possible, metres.
struct FlatChart
{
    std::vector<std::uint32_t> vertices; ///< of the mesh, ascending
    std::vector<std::uint32_t> triangles;
    std::vector<Vec2f> places; ///< per chart vertex; up on the body is up here
};

/// Least-squares conformal maps, then as-rigid-as-possible iterations (Lévy et al. 2002; Liu et al. 2008).
FlatChart flattenChart(const SurfaceMesh& mesh, const ChartLabels& labels, std::uint16_t chart);

/// Places charts in the unit square as large as they fit, `gap` apart.
/// \param sizes factor on each chart's size.
/// \return per chart the places of its vertices in [0, 1]².
std::vector<std::vector<Vec2f>> packCharts(const SurfaceMesh& mesh, const std::vector<FlatChart>& charts,
                                           const std::vector<double>& sizes);

/// Texture coordinates of a mesh, with seams.
struct Atlas
{
    std::vector<Vec2f> uvs;
    std::vector<std::array<std::uint32_t, 3>> triangleUvs;
    ChartLabels charts;
};

Atlas makeAtlas(const SurfaceMesh& mesh, const Body& body);

} // namespace quadrille
