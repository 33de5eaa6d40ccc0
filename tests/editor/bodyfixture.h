// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editortest.h"

#include <QDir>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace quadrille::test {

/// A standing figure of blocks with rounded edges, 1.8 m high, arms to the sides, toes forward (+z); left and
/// right alike, its left arm towards +x.
class BlockFigure
{
public:
    BlockFigure()
    {
        fill({-4, 16, -2}, {4, 30, 2});   // torso
        fill({-2, 30, -2}, {2, 36, 2});   // head
        fill({4, 26, -2}, {16, 30, 2});   // arms
        fill({-16, 26, -2}, {-4, 30, 2}); //
        fill({1, 0, -2}, {4, 16, 2});     // legs
        fill({-4, 0, -2}, {-1, 16, 2});
        fill({1, 0, 2}, {4, 2, 5}); // feet
        fill({-4, 0, 2}, {-1, 2, 5});
        makeFaces();
        for (int i = 0; i < 6; ++i)
            smoothen();
    }

    /// An OBJ series of a few frames, in which the figure rises slowly.
    void write(const QString& folder, int frames) const
    {
        QDir().mkpath(folder);
        for (int f = 0; f < frames; ++f) {
            std::ofstream file(
                QStringLiteral("%1/f_%2.obj").arg(folder).arg(f, 3, 10, QLatin1Char('0')).toStdString());
            for (const auto& point : m_points)
                file << "v " << point[0] << ' ' << point[1] + 0.01 * f << ' ' << point[2] << '\n';
            for (const auto& face : m_faces) {
                file << 'f';
                for (const int corner : face)
                    file << ' ' << corner + 1;
                file << '\n';
            }
        }
    }

private:
    using Cell = std::array<int, 3>;
    static constexpr double side = 0.05; // metres

    void fill(const Cell& from, const Cell& to)
    {
        for (int x = from[0]; x < to[0]; ++x)
            for (int y = from[1]; y < to[1]; ++y)
                for (int z = from[2]; z < to[2]; ++z)
                    m_cells.insert({x, y, z});
    }
    int vertexAt(const Cell& corner)
    {
        const auto [found, isNew] = m_vertices.try_emplace(corner, static_cast<int>(m_points.size()));
        if (isNew)
            m_points.push_back({side * corner[0], side * corner[1], side * corner[2]});
        return found->second;
    }
    void makeFaces()
    {
        for (const Cell& cell : m_cells)
            for (std::size_t axis = 0; axis < 3; ++axis)
                for (const int direction : {0, 1}) {
                    Cell next = cell;
                    next[axis] += 2 * direction - 1;
                    if (m_cells.contains(next))
                        continue;
                    Cell corner = cell;
                    corner[axis] += direction;
                    Cell u{};
                    Cell v{};
                    u[(axis + 1) % 3] = 1;
                    v[(axis + 2) % 3] = 1;
                    if (direction == 0)
                        std::swap(u, v);
                    const auto sum = [](Cell a, const Cell& b) {
                        for (std::size_t i = 0; i < 3; ++i)
                            a[i] += b[i];
                        return a;
                    };
                    m_faces.push_back({vertexAt(corner), vertexAt(sum(corner, u)),
                                       vertexAt(sum(sum(corner, u), v)), vertexAt(sum(corner, v))});
                }
    }
    void smoothen()
    {
        std::vector<std::set<int>> neighbours(m_points.size());
        for (const auto& face : m_faces)
            for (std::size_t i = 0; i < 4; ++i) {
                neighbours[static_cast<std::size_t>(face[i])].insert(face[(i + 1) % 4]);
                neighbours[static_cast<std::size_t>(face[(i + 1) % 4])].insert(face[i]);
            }
        const auto before = m_points;
        for (std::size_t vertex = 0; vertex < m_points.size(); ++vertex)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double mean = 0;
                for (const int other : neighbours[vertex])
                    mean += before[static_cast<std::size_t>(other)][axis];
                mean /= static_cast<double>(neighbours[vertex].size());
                m_points[vertex][axis] = (before[vertex][axis] + mean) / 2;
            }
    }

    std::set<Cell> m_cells;
    std::map<Cell, int> m_vertices;
    std::vector<std::array<double, 3>> m_points;
    std::vector<std::array<int, 4>> m_faces;
};

/// A project with one sequence "stand" of the figure.
inline Project figureProject(const QString& folder)
{
    const QString take = QDir(folder).filePath(QStringLiteral("stand"));
    BlockFigure().write(take, 3);
    Project project;
    project.characters = {{.name = "figure", .mesh = (take + "/f_000.obj").toStdString()}};
    project.sequences.push_back({.name = "stand", .character = "figure", .source = take.toStdString()});
    return project;
}

} // namespace quadrille::test
