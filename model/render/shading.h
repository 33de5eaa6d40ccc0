// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/render/tiles.h"
#include "model/sequence/axes.h"
#include "model/sequence/topology.h"

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Which triangles meet at each vertex.
struct IncidentTriangles
{
    std::vector<std::uint32_t> starts; ///< vertices + 1 offsets into `triangles`
    std::vector<std::uint32_t> triangles;
};
IncidentTriangles trianglesOfVertices(std::span<const Triangle> triangles, std::uint32_t vertexCount);

/// Smooth unit normals: the mean of the vertex's triangles, weighted by area; zero where there is none.
std::vector<Vec3f> vertexNormals(Positions positions, std::span<const Triangle> triangles,
                                 const IncidentTriangles& neighbours);

/// How a surface answers to light.
struct Material
{
    float diffuse;  ///< share of directed light
    float ambient;  ///< share of light from all around
    float specular; ///< strength of the highlight
    float rim;      ///< strength of the light from behind
};
inline constexpr Material clayMaterial{0.86F, 0.36F, 0.10F, 0.30F};
/// Captured textures hold light already: mostly ambient.
inline constexpr Material texturedMaterial{0.57F, 0.68F, 0.03F, 0.22F};

/// A key, a fill and a rim light that stand around the camera, and a sky above a floor.
class Lights
{
public:
    Lights(const Projection& projection, UpAxis up);

    /// Unit vector towards the key light.
    const Vec3f& key() const { return m_key; }
    /// Light that a surface sends to the eye.
    /// \param color linear. \param normal unit, on the seen side. \param toEye unit.
    Vec3f shade(const Vec3f& color, const Vec3f& normal, const Vec3f& toEye, const Material& material) const;

private:
    Vec3f m_up;
    Vec3f m_key;
    Vec3f m_fill;
    Vec3f m_rim;
};

} // namespace quadrille
