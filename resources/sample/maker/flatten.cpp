// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "resources/sample/maker/atlas.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;
using Places = Eigen::MatrixX2d;

/// A triangle of the chart: its corners (chart vertices) and its shape in its own plane.
struct FlatTriangle
{
    std::array<int, 3> corner;
    std::array<Eigen::Vector2d, 3> shape;
    double area = 0;
    std::array<double, 3> cotangent; ///< at each corner, bounded from below
};

std::vector<FlatTriangle> chartTriangles(const SurfaceMesh& mesh, const FlatChart& chart)
{
    std::vector<FlatTriangle> triangles;
    for (const std::uint32_t t : chart.triangles) {
        FlatTriangle flat;
        std::array<Vec3d, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t v = mesh.triangles[t][c].value;
            p[c] = mesh.points[v];
            flat.corner[c] = static_cast<int>(
                std::lower_bound(chart.vertices.begin(), chart.vertices.end(), v) - chart.vertices.begin());
        }
        const Vec3d x = (p[1] - p[0]).normalized();
        const Vec3d y = (p[1] - p[0]).cross(p[2] - p[0]).normalized().cross(x);
        for (std::size_t c = 0; c < 3; ++c)
            flat.shape[c] = {x.dot(p[c] - p[0]), y.dot(p[c] - p[0])};
        flat.area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
        for (std::size_t c = 0; c < 3; ++c)
            flat.cotangent[c] =
                std::max(0.05, (p[(c + 1) % 3] - p[c]).dot(p[(c + 2) % 3] - p[c]) / (2 * flat.area));
        triangles.push_back(flat);
    }
    return triangles;
}

/// The two vertices between which the chart is longest, by two sweeps.
std::pair<int, int> farthestPair(const SurfaceMesh& mesh, const FlatChart& chart)
{
    const auto farthestFrom = [&](int from) {
        const Vec3d& origin = mesh.points[chart.vertices[static_cast<std::size_t>(from)]];
        int best = 0;
        double distance = -1;
        for (std::size_t v = 0; v < chart.vertices.size(); ++v)
            if (const double d = (mesh.points[chart.vertices[v]] - origin).norm(); d > distance) {
                distance = d;
                best = static_cast<int>(v);
            }
        return best;
    };
    const int one = farthestFrom(0);
    return {one, farthestFrom(one)};
}

Places conformalMap(const std::vector<FlatTriangle>& triangles, int vertexCount, std::pair<int, int> pins,
                    double pinDistance)
{
    // Unknowns u then v, pinned ones kept by a strong weight.
    std::vector<Triplet> entries;
    int row = 0;
    for (const FlatTriangle& t : triangles) {
        const double scale = 1 / std::sqrt(2 * t.area);
        for (std::size_t c = 0; c < 3; ++c) {
            const Eigen::Vector2d w = scale * (t.shape[(c + 2) % 3] - t.shape[(c + 1) % 3]);
            entries.emplace_back(row, t.corner[c], w.x());
            entries.emplace_back(row, vertexCount + t.corner[c], -w.y());
            entries.emplace_back(row + 1, t.corner[c], w.y());
            entries.emplace_back(row + 1, vertexCount + t.corner[c], w.x());
        }
        row += 2;
    }
    constexpr double strong = 1e3;
    const int rows = row + 4;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(rows);
    for (const int column : {pins.first, pins.second, vertexCount + pins.first, vertexCount + pins.second}) {
        entries.emplace_back(row, column, strong);
        if (column == pins.second)
            right[row] = strong * pinDistance;
        ++row;
    }
    Sparse A(rows, Eigen::Index{2} * vertexCount);
    A.setFromTriplets(entries.begin(), entries.end());
    const Sparse normal = A.transpose() * A;
    const Eigen::SimplicialLDLT<Sparse> solver(normal);
    const Eigen::VectorXd solution = solver.solve(A.transpose() * right);
    Places places(vertexCount, 2);
    places.col(0) = solution.head(vertexCount);
    places.col(1) = solution.tail(vertexCount);
    return places;
}

/// The mesh pressed flat along the direction that a chart faces on average.
/// \param thickness  what is left of it: 1 all, 0 nothing.
SurfaceMesh pressed(const SurfaceMesh& mesh, const FlatChart& chart, double thickness)
{
    Vec3d normal = Vec3d::Zero();
    for (const std::uint32_t t : chart.triangles) {
        const Triangle& v = mesh.triangles[t];
        const Vec3d& a = mesh.points[v[0].value];
        normal += (mesh.points[v[1].value] - a).cross(mesh.points[v[2].value] - a);
    }
    normal.normalize();
    SurfaceMesh flatter = mesh;
    for (const std::uint32_t v : chart.vertices)
        flatter.points[v] -= (1 - thickness) * normal.dot(mesh.points[v]) * normal;
    return flatter;
}

/// Local/global iterations; the map tends to an isometry.
void makeRigid(const std::vector<FlatTriangle>& triangles, int iterations, Places& places)
{
    const auto n = static_cast<int>(places.rows());
    std::vector<Triplet> entries;
    for (const FlatTriangle& t : triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const int i = t.corner[(c + 1) % 3];
            const int j = t.corner[(c + 2) % 3];
            const double w = t.cotangent[c];
            entries.emplace_back(i, i, w);
            entries.emplace_back(j, j, w);
            entries.emplace_back(i, j, -w);
            entries.emplace_back(j, i, -w);
        }
    entries.emplace_back(0, 0, 1.0);
    Sparse L(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Sparse> solver(L);
    for (int iteration = 0; iteration < iterations; ++iteration) {
        Places right = Places::Zero(n, 2);
        right.row(0) = places.row(0);
        for (const FlatTriangle& t : triangles) {
            Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t a = (c + 1) % 3;
                const std::size_t b = (c + 2) % 3;
                S += t.cotangent[c] * (places.row(t.corner[a]) - places.row(t.corner[b])).transpose() *
                     (t.shape[a] - t.shape[b]).transpose();
            }
            const double angle = std::atan2(S(1, 0) - S(0, 1), S(0, 0) + S(1, 1));
            const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t a = (c + 1) % 3;
                const std::size_t b = (c + 2) % 3;
                const Eigen::Vector2d d = t.cotangent[c] * (R * (t.shape[a] - t.shape[b]));
                right.row(t.corner[a]) += d.transpose();
                right.row(t.corner[b]) -= d.transpose();
            }
        }
        places = solver.solve(right);
    }
}

bool hasFlips(const std::vector<FlatTriangle>& triangles, const Places& places)
{
    return std::any_of(triangles.begin(), triangles.end(), [&](const FlatTriangle& t) {
        const Eigen::Vector2d a = (places.row(t.corner[1]) - places.row(t.corner[0])).transpose();
        const Eigen::Vector2d b = (places.row(t.corner[2]) - places.row(t.corner[0])).transpose();
        return a.x() * b.y() - a.y() * b.x() <= 1e-3 * t.area;
    });
}

/// Whether two triangles of the map lie over each other: samples a grid over the map.
bool overlapsItself(const std::vector<FlatTriangle>& triangles, const Places& places)
{
    constexpr int cells = 1600;
    const Eigen::RowVector2d low = places.colwise().minCoeff();
    const double scale = cells / (places.colwise().maxCoeff() - low).maxCoeff();
    std::vector<bool> covered(std::size_t{cells + 1} * (cells + 1));
    for (const FlatTriangle& t : triangles) {
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = scale * (places.row(t.corner[c]) - low).transpose();
        const auto least = [&](int axis) {
            return static_cast<int>(std::ceil(std::min({p[0][axis], p[1][axis], p[2][axis]}) - 0.5));
        };
        const auto most = [&](int axis) {
            return static_cast<int>(std::floor(std::max({p[0][axis], p[1][axis], p[2][axis]}) - 0.5));
        };
        const auto isLeft = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& q) {
            return (b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x()) > 1e-9;
        };
        for (int y = std::max(least(1), 0); y <= most(1); ++y)
            for (int x = std::max(least(0), 0); x <= most(0); ++x) {
                const Eigen::Vector2d q(x + 0.5, y + 0.5);
                if (!isLeft(p[0], p[1], q) || !isLeft(p[1], p[2], q) || !isLeft(p[2], p[0], q))
                    continue;
                auto cell = covered[static_cast<std::size_t>(y) * (cells + 1) + static_cast<std::size_t>(x)];
                if (cell)
                    return true;
                cell = true;
            }
    }
    return false;
}

/// Turns the map so that up on the body is up, and gives it the chart's own area.
void orient(const SurfaceMesh& mesh, const std::vector<FlatTriangle>& triangles, const FlatChart& chart,
            Places& places)
{
    double area = 0;
    double flatArea = 0;
    for (const FlatTriangle& t : triangles) {
        const Eigen::Vector2d a = (places.row(t.corner[1]) - places.row(t.corner[0])).transpose();
        const Eigen::Vector2d b = (places.row(t.corner[2]) - places.row(t.corner[0])).transpose();
        area += t.area;
        flatArea += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
    }
    const Eigen::RowVector2d centre = places.colwise().mean();
    Vec3d bodyCentre = Vec3d::Zero();
    for (const std::uint32_t v : chart.vertices)
        bodyCentre += mesh.points[v] / static_cast<double>(chart.vertices.size());
    Eigen::Vector2d up = Eigen::Vector2d::Zero();
    for (std::size_t v = 0; v < chart.vertices.size(); ++v) {
        const Vec3d d = mesh.points[chart.vertices[v]] - bodyCentre;
        up += (d.y() - 0.6 * d.z()) * (places.row(static_cast<Eigen::Index>(v)) - centre).transpose();
    }
    const double angle = std::atan2(up.x(), up.y());
    const Eigen::Matrix2d turn = std::sqrt(area / flatArea) * Eigen::Rotation2Dd(angle).toRotationMatrix();
    places = (places.rowwise() - centre) * turn.transpose();
}

} // namespace

FlatChart flattenChart(const SurfaceMesh& mesh, const ChartLabels& labels, std::uint16_t chart)
{
    FlatChart flat;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (labels.ofTriangle[t] != chart)
            continue;
        flat.triangles.push_back(static_cast<std::uint32_t>(t));
        for (const VertexIndex v : mesh.triangles[t])
            flat.vertices.push_back(v.value);
    }
    std::sort(flat.vertices.begin(), flat.vertices.end());
    flat.vertices.erase(std::unique(flat.vertices.begin(), flat.vertices.end()), flat.vertices.end());
    // As rigid as can be. Where that folds over – fingers laid flat are wider than they are apart – the chart
    // is taken from a surface pressed flatter.
    Places places;
    for (const double thickness : {1.0, 0.8, 0.65, 0.5, 0.35}) {
        const SurfaceMesh flatter = pressed(mesh, flat, thickness);
        const std::vector<FlatTriangle> triangles = chartTriangles(flatter, flat);
        const auto pins = farthestPair(flatter, flat);
        const double distance = (flatter.points[flat.vertices[static_cast<std::size_t>(pins.first)]] -
                                 flatter.points[flat.vertices[static_cast<std::size_t>(pins.second)]])
                                    .norm();
        const Places conformal =
            conformalMap(triangles, static_cast<int>(flat.vertices.size()), pins, distance);
        bool isGood = false;
        for (const int iterations : {30, 6, 2}) {
            places = conformal;
            orient(flatter, triangles, flat, places);
            makeRigid(triangles, iterations, places);
            orient(flatter, triangles, flat, places);
            isGood = !hasFlips(triangles, places) && !overlapsItself(triangles, places);
            if (isGood)
                break;
        }
        if (isGood)
            break;
    }
    for (Eigen::Index v = 0; v < places.rows(); ++v)
        flat.places.emplace_back(places.row(v).transpose().cast<float>());
    return flat;
}

} // namespace quadrille
