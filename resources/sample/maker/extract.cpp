// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Naive surface nets (Gibson 1998) on a grid whose first layer of cells straddles x = 0.
#include "resources/sample/maker/bodymesh.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

class Grid
{
public:
    Grid(const Body& body, double spacing) : m_spacing(spacing)
    {
        const Vec3d low(-0.5 * spacing, -0.02, -0.18);
        const Vec3d high(body.joints().fingertips.x() + 0.05, body.joints().headTop.y() + 0.04, 0.27);
        m_origin = low;
        for (int axis = 0; axis < 3; ++axis)
            m_nodes[static_cast<std::size_t>(axis)] =
                (static_cast<int>((high[axis] - low[axis]) / spacing) / blockSize + 2) * blockSize;
        const std::size_t count = static_cast<std::size_t>(m_nodes[0]) *
                                  static_cast<std::size_t>(m_nodes[1]) * static_cast<std::size_t>(m_nodes[2]);
        m_values.assign(count, 1.0F);
        m_isFar.assign(count / (std::size_t{blockSize} * blockSize * blockSize), 0);
    }

    int nodes(std::size_t axis) const { return m_nodes[axis]; }
    Vec3d position(int i, int j, int k) const { return m_origin + m_spacing * Vec3d(i, j, k); }
    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(j) * static_cast<std::size_t>(m_nodes[2]) +
                static_cast<std::size_t>(k)) *
                   static_cast<std::size_t>(m_nodes[0]) +
               static_cast<std::size_t>(i);
    }
    float value(int i, int j, int k) const { return m_values[index(i, j, k)]; }
    /// Calls `visit(i, j, k)` for the cells, in rows along i, from `first` on in each direction; those that
    /// are far from the surface are left out.
    template <typename Visit>
    void visitCells(int first, const Visit& visit) const
    {
        for (int j = first; j + 1 < m_nodes[1]; ++j)
            for (int k = first; k + 1 < m_nodes[2]; ++k)
                for (int i = first; i + 1 < m_nodes[0]; ++i) {
                    if (m_isFar[block(i, j, k)] != 0)
                        i |= blockSize - 1; // to the last of the block
                    else
                        visit(i, j, k);
                }
    }

    void fill(const Body& body)
    {
        const int layers = m_nodes[1] / blockSize;
        tbb::parallel_for(0, layers, [&](int layer) {
            for (int k = 0; k < m_nodes[2]; k += blockSize)
                for (int i = 0; i < m_nodes[0]; i += blockSize)
                    fillBlock(body, i, layer * blockSize, k);
        });
    }

    /// Turns the sign of the smallest value in every cell whose corners of one sign do not hang together,
    /// until there is none: each cell then holds one sheet of surface, and the surface is a manifold.
    void makeCellsSimple()
    {
        for (bool changed = true; changed;) {
            changed = false;
            visitCells(0, [&](int i, int j, int k) { changed = makeCellSimple(i, j, k) || changed; });
        }
    }

private:
    static constexpr int blockSize = 4; ///< a power of two
    /// As many node spacings from the surface no cell of a block, nor the next one, touches it.
    static constexpr double farAway = 3.0 * blockSize;

    std::size_t block(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(j / blockSize) * static_cast<std::size_t>(m_nodes[2] / blockSize) +
                static_cast<std::size_t>(k / blockSize)) *
                   static_cast<std::size_t>(m_nodes[0] / blockSize) +
               static_cast<std::size_t>(i / blockSize);
    }

    std::size_t cornerIndex(int i, int j, int k, int corner) const
    {
        return index(i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2));
    }

    bool makeCellSimple(int i, int j, int k)
    {
        unsigned inside = 0;
        for (int corner = 0; corner < 8; ++corner)
            inside |= (m_values[cornerIndex(i, j, k, corner)] < 0 ? 1U : 0U) << corner;
        if (hangsTogether(inside) && hangsTogether(~inside & 0xffU))
            return false;
        int smallest = 0;
        for (int corner = 1; corner < 8; ++corner)
            if (std::abs(m_values[cornerIndex(i, j, k, corner)]) <
                std::abs(m_values[cornerIndex(i, j, k, smallest)]))
                smallest = corner;
        float& value = m_values[cornerIndex(i, j, k, smallest)];
        // Larger than before, so that the next cell does not turn it back.
        value = -1.5F * (std::abs(value) < 1e-6F ? std::copysign(1e-6F, value) : value);
        // The nodes on both sides of x = 0 mirror each other.
        if (const int column = i + (smallest & 1); column < 2)
            m_values[index(1 - column, j + ((smallest >> 1) & 1), k + (smallest >> 2))] = value;
        return true;
    }

    /// Whether some corners of a cube (bits) are joined by its edges.
    static bool hangsTogether(unsigned corners)
    {
        unsigned reached = corners & (~corners + 1U);
        for (unsigned before = 0; before != reached;) {
            before = reached;
            const unsigned alongX = ((reached & 0x55U) << 1) | ((reached & 0xaaU) >> 1);
            const unsigned alongY = ((reached & 0x33U) << 2) | ((reached & 0xccU) >> 2);
            const unsigned alongZ = ((reached & 0x0fU) << 4) | ((reached & 0xf0U) >> 4);
            reached |= (alongX | alongY | alongZ) & corners;
        }
        return reached == corners;
    }

    /// A block far from the surface gets the sign of its centre.
    void fillBlock(const Body& body, int i0, int j0, int k0)
    {
        const Vec3d centre = position(i0, j0, k0) + Vec3d::Constant(0.5 * (blockSize - 1) * m_spacing);
        const double middle = body.distance(centre);
        const bool isFar = std::abs(middle) > farAway * m_spacing;
        m_isFar[block(i0, j0, k0)] = isFar ? 1 : 0;
        for (int j = j0; j < j0 + blockSize; ++j)
            for (int k = k0; k < k0 + blockSize; ++k)
                for (int i = i0; i < i0 + blockSize; ++i)
                    m_values[index(i, j, k)] =
                        static_cast<float>(isFar ? middle : body.distance(position(i, j, k)));
    }

    double m_spacing;
    Vec3d m_origin;
    std::array<int, 3> m_nodes{};
    std::vector<float> m_values;
    std::vector<std::uint8_t> m_isFar; ///< per block
};

constexpr std::uint32_t noVertex = ~0U;

/// The mean of the crossings of a cell's edges, if the surface passes through the cell.
bool cellPoint(const Grid& grid, int i, int j, int k, Vec3d& point)
{
    Vec3d sum = Vec3d::Zero();
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::array<int, 3> step = {axis == 0, axis == 1, axis == 2};
        for (int side = 0; side < 4; ++side) {
            std::array<int, 3> at = {i, j, k};
            at[static_cast<std::size_t>((axis + 1) % 3)] += side & 1;
            at[static_cast<std::size_t>((axis + 2) % 3)] += side >> 1;
            const double a = grid.value(at[0], at[1], at[2]);
            const double b = grid.value(at[0] + step[0], at[1] + step[1], at[2] + step[2]);
            if ((a < 0) == (b < 0))
                continue;
            const Vec3d pa = grid.position(at[0], at[1], at[2]);
            const Vec3d pb = grid.position(at[0] + step[0], at[1] + step[1], at[2] + step[2]);
            sum += pa + a / (a - b) * (pb - pa);
            ++crossings;
        }
    }
    if (crossings == 0)
        return false;
    point = sum / crossings;
    return true;
}

} // namespace

SurfaceMesh extractHalfSurface(const Body& body, double spacing)
{
    Grid grid(body, spacing);
    grid.fill(body);
    grid.makeCellsSimple();
    SurfaceMesh mesh;
    std::vector<std::uint32_t> vertexOfCell(
        grid.index(grid.nodes(0) - 1, grid.nodes(1) - 1, grid.nodes(2) - 1) + 1, noVertex);
    grid.visitCells(0, [&](int i, int j, int k) {
        Vec3d point;
        if (!cellPoint(grid, i, j, k, point))
            return;
        if (i == 0)
            point.x() = 0;
        vertexOfCell[grid.index(i, j, k)] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back(point);
    });
    const auto addQuad = [&](std::array<std::size_t, 4> cells, bool flipped) {
        std::array<VertexIndex, 4> v;
        for (std::size_t c = 0; c < 4; ++c)
            v[c] = VertexIndex(vertexOfCell[cells[flipped ? 3 - c : c]]);
        mesh.triangles.push_back({v[0], v[1], v[2]});
        mesh.triangles.push_back({v[0], v[2], v[3]});
    };
    grid.visitCells(1, [&](int i, int j, int k) {
        const bool inside = grid.value(i, j, k) < 0;
        const auto cell = [&](int di, int dj, int dk) { return grid.index(i - di, j - dj, k - dk); };
        if (inside != (grid.value(i + 1, j, k) < 0))
            addQuad({cell(0, 0, 0), cell(0, 1, 0), cell(0, 1, 1), cell(0, 0, 1)}, !inside);
        if (inside != (grid.value(i, j + 1, k) < 0))
            addQuad({cell(0, 0, 0), cell(0, 0, 1), cell(1, 0, 1), cell(1, 0, 0)}, !inside);
        if (inside != (grid.value(i, j, k + 1) < 0))
            addQuad({cell(0, 0, 0), cell(1, 0, 0), cell(1, 1, 0), cell(0, 1, 0)}, !inside);
    });
    return mesh;
}

} // namespace quadrille
