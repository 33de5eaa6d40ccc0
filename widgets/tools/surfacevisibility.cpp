// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/tools/surfacevisibility.h"

#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

/// A vertex on the view.
struct Projected
{
    float x = 0; ///< pixels
    float y = 0;
    float depth = 0; ///< metres in front of the camera; not positive behind it
};

std::vector<Projected> projected(const FigureShape& figure, const Turntable& camera, const QSizeF& view)
{
    const QVector3D eye = camera.position() - figure.shift;
    const QVector3D forward = camera.forward();
    const QVector3D right = camera.right();
    const QVector3D up = camera.up();
    const float pixels = camera.distance / camera.metresPerPixel(view);
    const auto width = static_cast<float>(view.width());
    const auto height = static_cast<float>(view.height());
    std::vector<Projected> result(figure.mesh.vertexCount);
    for (std::size_t i = 0; i < result.size(); ++i) {
        const float* p = &figure.positions[3 * i];
        const QVector3D ray = QVector3D(p[0], p[1], p[2]) - eye;
        const float depth = QVector3D::dotProduct(ray, forward);
        result[i].depth = depth;
        if (depth > 0.0F) {
            result[i].x = width / 2.0F + QVector3D::dotProduct(ray, right) * pixels / depth;
            result[i].y = height / 2.0F - QVector3D::dotProduct(ray, up) * pixels / depth;
        }
    }
    return result;
}

/// The asked vertices by the square of the view that they are in.
class Squares
{
public:
    Squares(const std::vector<Projected>& all, std::span<const std::uint32_t> asked, const QSizeF& view)
        : m_columns(static_cast<int>(view.width()) / side + 1)
        , m_rows(static_cast<int>(view.height()) / side + 1)
        , m_squares(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows))
    {
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const Projected& at = all[asked[i]];
            if (at.depth > 0.0F && at.x >= 0.0F && at.y >= 0.0F && column(at.x) < m_columns &&
                row(at.y) < m_rows)
                m_squares[index(column(at.x), row(at.y))].push_back(i);
        }
    }
    /// \param test  takes the number of an asked vertex that may lie in a box of the view.
    template <typename Test>
    void forEachIn(float left, float right, float top, float bottom, const Test& test) const
    {
        if (right < 0.0F || bottom < 0.0F)
            return;
        const int lastColumn = std::min(column(right), m_columns - 1);
        const int lastRow = std::min(row(bottom), m_rows - 1);
        for (int y = row(std::max(top, 0.0F)); y <= lastRow; ++y)
            for (int x = column(std::max(left, 0.0F)); x <= lastColumn; ++x)
                for (const std::size_t asked : m_squares[index(x, y)])
                    test(asked);
    }

private:
    static constexpr int side = 16; // pixels
    static int column(float x) { return static_cast<int>(std::min(x, 1e6F)) / side; }
    static int row(float y) { return column(y); }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(x);
    }

    int m_columns;
    int m_rows;
    std::vector<std::vector<std::size_t>> m_squares;
};

/// Whether a triangle covers a point of the view and lies in front of it there.
bool hides(const std::array<Projected, 3>& corners, const Projected& point)
{
    const auto& [a, b, c] = corners;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (std::abs(area) < 1e-6F)
        return false;
    const float v = ((point.x - a.x) * (c.y - a.y) - (c.x - a.x) * (point.y - a.y)) / area;
    const float w = ((b.x - a.x) * (point.y - a.y) - (point.x - a.x) * (b.y - a.y)) / area;
    const float u = 1.0F - v - w;
    if (u < 0.0F || v < 0.0F || w < 0.0F)
        return false;
    // In perspective the inverse of depth is what is linear over the view.
    const float depth = 1.0F / (u / a.depth + v / b.depth + w / c.depth);
    constexpr float tolerance = 1e-4F; // of the depth, for rounding
    return depth < point.depth * (1.0F - tolerance);
}

} // namespace

std::vector<bool> visibleVertices(const FigureShape& figure, const Turntable& camera, const QSizeF& view,
                                  std::span<const std::uint32_t> vertices)
{
    const std::vector<Projected> all = projected(figure, camera, view);
    std::vector<bool> visible(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
        visible[i] = all[vertices[i]].depth > 0.0F;
    const Squares squares(all, vertices, view);
    for (const auto& triangle : figure.mesh.triangles) {
        const std::array<Projected, 3> corners{all[triangle[0]], all[triangle[1]], all[triangle[2]]};
        const auto& [a, b, c] = corners;
        if (a.depth <= 0.0F || b.depth <= 0.0F || c.depth <= 0.0F)
            continue;
        squares.forEachIn(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}),
                          std::max({a.y, b.y, c.y}), [&](std::size_t asked) {
                              const std::uint32_t vertex = vertices[asked];
                              if (visible[asked] &&
                                  std::find(triangle.begin(), triangle.end(), vertex) == triangle.end() &&
                                  hides(corners, all[vertex]))
                                  visible[asked] = false;
                          });
    }
    return visible;
}

} // namespace quadrille::widgets
