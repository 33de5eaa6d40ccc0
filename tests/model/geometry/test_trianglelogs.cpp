// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/geometry/trianglelogs.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace quadrille {
namespace {

using Eigen::Matrix3d;
constexpr double pi = std::numbers::pi;

/// Triangles that share no vertices, with random corners.
struct Soup
{
    std::vector<Triangle> triangles;
    std::vector<Vec3f> positions;

    explicit Soup(std::uint32_t count, unsigned seed = 1)
    {
        std::mt19937 random(seed);
        std::normal_distribution<float> real;
        for (std::uint32_t v = 0; v < 3 * count; ++v) {
            const float x = real(random);
            const float y = real(random);
            positions.emplace_back(x, y, real(random));
            if (v % 3 == 0)
                triangles.push_back({VertexIndex(v), VertexIndex(v + 1), VertexIndex(v + 2)});
        }
    }
    Vec3d edge(std::size_t triangle, std::size_t corner) const
    {
        const Triangle& t = triangles[triangle];
        return positions[t[corner].value].cast<double>() - positions[t[2].value].cast<double>();
    }
    Matrix3d frame(std::size_t triangle) const
    {
        Matrix3d frame;
        frame << edge(triangle, 0), edge(triangle, 1),
            edge(triangle, 0).cross(edge(triangle, 1)).normalized();
        return frame;
    }
};

Vec3d asVector(const std::array<double, 4>& edge)
{
    return {edge[0], edge[1], edge[2]};
}

TEST(PoseFrames, HoldTheEdges)
{
    const Soup soup(300);
    const PoseFrames frames = poseFrames(soup.triangles, soup.positions);
    EXPECT_TRUE(frames.degenerate.empty());
    for (std::size_t m = 0; m < frames.size(); ++m) {
        const Eigen::Quaterniond q(frames.qw[m], frames.qx[m], frames.qy[m], frames.qz[m]);
        EXPECT_NEAR(q.norm(), 1, 1e-12);
        EXPECT_LT((q * Vec3d(frames.b11[m], 0, 0) - soup.edge(m, 0)).norm(), 1e-12);
        EXPECT_LT((q * Vec3d(frames.b12[m], frames.b22[m], 0) - soup.edge(m, 1)).norm(), 1e-12);
        EXPECT_GT(frames.b22[m], 0);
    }
}

TEST(PoseFrames, NameTrianglesWithoutArea)
{
    Soup soup(70);
    const auto corner = [&soup](std::size_t triangle, std::size_t c) -> Vec3f& {
        return soup.positions[3 * triangle + c];
    };
    corner(5, 1) = corner(5, 0);                         // two corners in one
    corner(66, 0) = (corner(66, 1) + corner(66, 2)) / 2; // all in one line
    for (std::size_t c = 0; c < 3; ++c)
        corner(69, c) = Vec3f(1, 1, 1); // all in one point
    const PoseFrames frames = poseFrames(soup.triangles, soup.positions);
    EXPECT_EQ(frames.degenerate, (std::vector<int>{5, 66, 69}));
    EXPECT_EQ(frames.b11[5], 1);
    EXPECT_EQ(frames.b22[69], 1);
}

/// exp(λ·log R)·exp(λ·log S) or its linear stretch, by SVD.
Matrix3d between(const Matrix3d& map, double lambda, StretchPath path)
{
    const Eigen::JacobiSVD<Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::AngleAxisd turn(Matrix3d(svd.matrixU() * svd.matrixV().transpose()));
    const Eigen::Array3d stretches = svd.singularValues();
    const Eigen::Array3d linear = 1 - lambda + lambda * stretches;
    const Vec3d part = path == StretchPath::Linear ? linear : Eigen::Array3d(stretches.pow(lambda));
    return Eigen::AngleAxisd(lambda * turn.angle(), turn.axis()).toRotationMatrix() * svd.matrixV() *
           part.asDiagonal() * svd.matrixV().transpose();
}

TEST(TriangleLogs, AgreeWithLogarithmsBySvd)
{
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Vec3d(1, 2, 3).normalized()));
    const Soup source(200, 1);
    // Other triangles; nearly the same ones; the same ones.
    for (const double difference : {1.0, 1e-4, 0.0}) {
        Soup target(200, 2);
        for (std::size_t v = 0; v < target.positions.size(); ++v) {
            const Vec3d mixed = (1 - difference) * source.positions[v].cast<double>() +
                                difference * target.positions[v].cast<double>();
            target.positions[v] = (turned * mixed).cast<float>();
        }
        const PoseFrames frames = poseFrames(source.triangles, source.positions);
        const TriangleLogs logs =
            triangleLogs(frames, poseFrames(target.triangles, target.positions), turned);
        std::vector<TriangleEdges> edges(frames.size());
        for (const StretchPath path : {StretchPath::Geodesic, StretchPath::Linear}) {
            for (const double lambda : {0.0, 0.3, 1.0}) {
                deformEdges(frames, logs, lambda, path, edges);
                for (std::size_t m = 0; m < edges.size(); ++m) {
                    const Matrix3d map = turned.conjugate() * target.frame(m) * source.frame(m).inverse();
                    const Matrix3d part = between(map, lambda, path);
                    EXPECT_LT((asVector(edges[m].first) - part * source.edge(m, 0)).norm(), 1e-9);
                    EXPECT_LT((asVector(edges[m].second) - part * source.edge(m, 1)).norm(), 1e-9);
                }
            }
        }
    }
}

/// A strip of triangles, each with an edge to the next.
std::shared_ptr<const PoissonSystem> strip(std::uint32_t count)
{
    TopologyData data;
    data.vertexCount = count + 2;
    for (std::uint32_t m = 0; m < count; ++m)
        data.triangles.push_back({VertexIndex(m), VertexIndex(m + 1), VertexIndex(m + 2)});
    return std::make_shared<const PoissonSystem>(std::make_shared<const Topology>(std::move(data)));
}

/// Logarithms of turns about z, in degrees: half angles in [0, 90] about z or −z.
TriangleLogs turnsAboutZ(const std::vector<double>& degrees)
{
    TriangleLogs logs;
    for (const double angle : degrees) {
        const double shortWay = std::remainder(angle, 360.0);
        logs.axisX.push_back(0);
        logs.axisY.push_back(0);
        logs.axisZ.push_back(shortWay < 0 ? -1 : 1);
        logs.halfAngle.push_back(std::abs(shortWay) / 360 * pi);
        logs.cosine.push_back(std::cos(logs.halfAngle.back()));
        logs.logScale.push_back(0);
        logs.logStretch.push_back(0);
        logs.u1.push_back(0);
        logs.u2.push_back(0);
    }
    return logs;
}

std::vector<double> degreesAboutZ(const TriangleLogs& logs)
{
    std::vector<double> degrees;
    for (std::size_t m = 0; m < logs.size(); ++m)
        degrees.push_back(std::round(logs.axisZ[m] * logs.halfAngle[m] * 360 / pi));
    return degrees;
}

std::vector<double> chosen(const std::vector<double>& degrees)
{
    TriangleLogs logs = turnsAboutZ(degrees);
    chooseBranches(*strip(static_cast<std::uint32_t>(degrees.size())), logs);
    return degreesAboutZ(logs);
}

TEST(ChooseBranches, FollowsATurnPastHalfATurn)
{
    const std::vector<double> up{0, 40, 80, 120, 160, 200, 240, 280, 320, 350};
    EXPECT_EQ(chosen(up), up);
    const std::vector<double> down{0, -60, -120, -170, -190, -250};
    EXPECT_EQ(chosen(down), down);
    const std::vector<double> thereAndBack{100, 150, 200, 150, 60, 10, -40};
    EXPECT_EQ(chosen(thereAndBack), thereAndBack);
}

TEST(ChooseBranches, LeavesAloneWhatFits)
{
    const std::vector<double> fits{0, 170, 10, -160, 15};
    EXPECT_EQ(chosen(fits), fits);
}

// One triangle turns by itself by 170 degrees; those behind it, at −20 degrees, do not follow.
TEST(ChooseBranches, DoesNotFollowASingleTriangle)
{
    const std::vector<double> strayed = chosen({0, 0, -20, 170, -20, -20, 0});
    EXPECT_EQ(strayed[4], -20);
    EXPECT_EQ(strayed[5], -20);
    EXPECT_EQ(strayed[6], 0);
    EXPECT_EQ(strayed[3], -190);
}

TEST(BorrowRotations, TakesThoseOfTheNearestTriangles)
{
    TriangleLogs logs = turnsAboutZ({10, 99, 99, 99, 50});
    const std::vector<int> without{1, 2, 3};
    borrowRotations(*strip(5), without, logs);
    const std::vector<double> degrees = degreesAboutZ(logs);
    EXPECT_EQ(degrees[1], 10);
    EXPECT_EQ(degrees[3], 50);
    EXPECT_TRUE(degrees[2] == 10 || degrees[2] == 50);

    TriangleLogs none = turnsAboutZ({99, 99});
    const std::vector<int> all{0, 1};
    borrowRotations(*strip(2), all, none);
    EXPECT_EQ(degreesAboutZ(none), (std::vector<double>{0, 0}));
}

// The solution is a minimum of Σ area·‖gradient − wanted gradient‖²: its differences vanish.
TEST(PoissonPose, FindsTheSurfaceNearestToDeformedTriangles)
{
    const auto system = strip(12);
    std::mt19937 random(3);
    std::normal_distribution<double> real;
    std::vector<Vec3f> rest;
    for (std::size_t v = 0; v < system->vertexCount(); ++v) {
        const float offset = 0.1F * static_cast<float>(real(random));
        rest.emplace_back(static_cast<float>(v), v % 2 == 0 ? 0.0F : 1.3F, offset);
    }
    std::vector<TriangleEdges> edges(system->triangleCount());
    for (TriangleEdges& e : edges) {
        e.first = {real(random), real(random), real(random), 0};
        e.second = {real(random), real(random), real(random), 0};
    }
    const std::vector<Triangle>& triangles = system->topology().triangles();
    const PoissonPose pose(*system, poseFrames(triangles, rest));
    std::vector<double> x;
    pose.solve(edges, x);
    std::vector<Vec3d> solution;
    for (const int row : system->rows())
        solution.emplace_back(Vec3d::Map(x.data() + std::ptrdiff_t{4} * row));

    const auto energy = [&](const std::vector<Vec3d>& surface) {
        double sum = 0;
        for (std::size_t m = 0; m < triangles.size(); ++m) {
            const auto corner = [&](std::size_t c) { return triangles[m][c].value; };
            Matrix3d frame;
            frame.col(0) = (rest[corner(0)] - rest[corner(2)]).cast<double>();
            frame.col(1) = (rest[corner(1)] - rest[corner(2)]).cast<double>();
            const Vec3d normal = frame.col(0).cross(frame.col(1));
            frame.col(2) = normal.normalized();
            Matrix3d difference = Matrix3d::Zero();
            difference.col(0) = surface[corner(0)] - surface[corner(2)] - asVector(edges[m].first);
            difference.col(1) = surface[corner(1)] - surface[corner(2)] - asVector(edges[m].second);
            sum += 0.25 * normal.norm() * (difference * frame.inverse()).squaredNorm();
        }
        return sum;
    };
    for (std::size_t v = 0; v < solution.size(); ++v) {
        for (Eigen::Index c = 0; c < 3; ++c) {
            constexpr double step = 1e-4;
            std::vector<Vec3d> more = solution;
            std::vector<Vec3d> less = solution;
            more[v][c] += step;
            less[v][c] -= step;
            EXPECT_NEAR((energy(more) - energy(less)) / (2 * step), 0, 1e-9) << v << ", " << c;
            EXPECT_GT(energy(more), energy(solution));
        }
    }
}

} // namespace
} // namespace quadrille
