// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/cameraview.h"

#include "model/render/tiles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// 0 below 0, 1 above 1, smooth in between.
double faded(double value)
{
    const double t = std::clamp(value, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// As the renderer places its pictures: samples have their middle half a sample further.
Projection idealProjection(const PinholeCamera& camera, const Vec2d& middle, int width, int height,
                           double farthest)
{
    Projection projection(Camera(), width, height);
    projection.eye = camera.centre();
    projection.right = camera.rotation.row(0).transpose() * (camera.fx / camera.fy);
    projection.up = -camera.rotation.row(1).transpose();
    projection.forward = camera.rotation.row(2).transpose();
    projection.focal = camera.fy;
    projection.centerX = middle.x() + 0.5;
    projection.centerY = middle.y() + 0.5;
    projection.nearDistance = 1e-4 * farthest;
    projection.farDistance = 2 * farthest;
    return projection;
}

} // namespace

CameraView::CameraView(const PinholeCamera& camera, Positions positions, std::span<const Triangle> triangles,
                       const SightOptions& options)
    : m_camera(camera), m_lens(camera), m_options(options), m_centre(camera.centre())
{
    frameIdealPicture();
    double farthest = 0;
    for (const Vec3f& position : positions)
        farthest = std::max(farthest, camera.inCamera(position.cast<double>()).z());
    if (farthest <= 0)
        return; // all lies behind the camera
    m_planes.reserve(triangles.size());
    for (const Triangle& triangle : triangles) {
        std::array<Vec3d, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = camera.inCamera(positions[triangle[c].value].cast<double>());
        const Vec3d normal = (p[1] - p[0]).cross(p[2] - p[0]);
        m_planes.push_back({normal, normal.dot(p[0])});
    }
    m_seen = rasterize(positions, triangles, idealProjection(camera, m_middle, m_width, m_height, farthest),
                       m_width, m_height);
    measureEdges();
}

/// A picture without distortion that holds all that the camera's shows, as far as it is not very much wider.
void CameraView::frameIdealPicture()
{
    m_width = m_camera.width;
    m_height = m_camera.height;
    m_middle = {m_camera.cx, m_camera.cy};
    if (!m_lens.isDistorted())
        return;
    const Vec2d focal(m_camera.fx, m_camera.fy);
    Vec2d low = Vec2d::Constant(std::numeric_limits<double>::infinity());
    Vec2d high = -low;
    const auto add = [&](double x, double y) {
        if (const auto ideal = m_lens.idealOf({x, y})) {
            low = low.cwiseMin(ideal->cwiseProduct(focal));
            high = high.cwiseMax(ideal->cwiseProduct(focal));
        }
    };
    constexpr int steps = 64;
    for (int i = 0; i <= steps; ++i) {
        const double x = (m_camera.width - 1.0) * i / steps;
        const double y = (m_camera.height - 1.0) * i / steps;
        add(x, 0);
        add(x, m_camera.height - 1);
        add(0, y);
        add(m_camera.width - 1, y);
    }
    // Where the lens shows nothing at the border, as a circle in a picture, all of the circle is taken.
    const Vec2d size(m_camera.width, m_camera.height);
    const Vec2d reach = (m_lens.limit() * focal).cwiseMin(size);
    if (!low.allFinite() || !high.allFinite()) {
        low = -reach;
        high = reach;
    }
    low = low.cwiseMax(-1.5 * size).array().floor() - 1;
    high = high.cwiseMin(1.5 * size).array().ceil() + 1;
    m_middle = -low;
    constexpr int largest = 16384; // see rasterize
    m_width = std::clamp(static_cast<int>(high.x() - low.x()) + 1, 1, largest);
    m_height = std::clamp(static_cast<int>(high.y() - low.y()) + 1, 1, largest);
}

Vec2d CameraView::idealAt(std::size_t sample) const
{
    const auto width = static_cast<std::size_t>(m_width);
    const std::size_t row = sample / width;
    const std::size_t column = sample % width;
    return {(static_cast<double>(column) - m_middle.x()) / m_camera.fx,
            (static_cast<double>(row) - m_middle.y()) / m_camera.fy};
}

/// Whether two neighbouring samples show surfaces of which one lies in front of the other. A surface that
/// goes on is as far at one of them as the plane of the other says.
bool CameraView::isStep(std::size_t a, std::size_t b) const
{
    const std::uint32_t first = m_seen.triangles[a];
    const std::uint32_t second = m_seen.triangles[b];
    if (first == second)
        return false;
    if (first == noTriangle || second == noTriangle)
        return true;
    const auto differs = [&](std::uint32_t triangle, std::size_t at) {
        const double depth = double{m_seen.depths[at]};
        const double expected = depthAt(triangle, idealAt(at));
        return !(std::abs(expected - depth) <= m_options.depthTolerance * depth);
    };
    return differs(first, b) && differs(second, a);
}

void CameraView::measureEdges()
{
    cv::Mat apart(m_height, m_width, CV_8UC1, cv::Scalar(1));
    const auto width = static_cast<std::size_t>(m_width);
    // Each sample is written by its own row.
    tbb::parallel_for(tbb::blocked_range<int>(0, m_height, 16), [&](const auto& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            for (int x = 0; x < m_width; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
                if ((x > 0 && isStep(at - 1, at)) || (x + 1 < m_width && isStep(at, at + 1)) ||
                    (y > 0 && isStep(at - width, at)) || (y + 1 < m_height && isStep(at, at + width)))
                    apart.data[at] = 0;
            }
        }
    });
    m_edges.resize(width * static_cast<std::size_t>(m_height));
    cv::Mat distances(m_height, m_width, CV_32FC1, m_edges.data());
    cv::distanceTransform(apart, distances, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
}

/// Whether something lies before a point that is seen at a sample: neither does the surface of the point
/// reach that sample, nor what is seen there the point.
bool CameraView::isHidden(const SurfaceSample& sample, const Vec3d& place, int x, int y) const
{
    const std::size_t at =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    const std::uint32_t seen = m_seen.triangles[at];
    if (seen == sample.triangle.value)
        return false;
    if (seen == noTriangle)
        return true;
    const double kept = 1 - m_options.depthTolerance;
    const double depth = double{m_seen.depths[at]};
    if (depth >= kept * depthAt(sample.triangle.value, idealAt(at)) && depth >= kept * kept * place.z())
        return false;
    const double front = depthAt(seen, place.head<2>() / place.z());
    return !(front >= kept * place.z());
}

/// Between samples.
double CameraView::edgeDistance(const Vec2d& at) const
{
    const int x = std::clamp(static_cast<int>(std::floor(at.x())), 0, std::max(m_width - 2, 0));
    const int y = std::clamp(static_cast<int>(std::floor(at.y())), 0, std::max(m_height - 2, 0));
    const auto value = [&](int i, int j) {
        return double{
            m_edges[static_cast<std::size_t>(std::min(j, m_height - 1)) * static_cast<std::size_t>(m_width) +
                    static_cast<std::size_t>(std::min(i, m_width - 1))]};
    };
    const double fx = std::clamp(at.x() - x, 0.0, 1.0);
    const double fy = std::clamp(at.y() - y, 0.0, 1.0);
    return (value(x, y) * (1 - fx) + value(x + 1, y) * fx) * (1 - fy) +
           (value(x, y + 1) * (1 - fx) + value(x + 1, y + 1) * fx) * fy;
}

std::optional<Sight> CameraView::sightOf(const SurfaceSample& sample) const
{
    if (m_planes.empty())
        return std::nullopt;
    const Vec3d toEye = m_centre - sample.point;
    const double cosine = sample.normal.dot(toEye) / toEye.norm();
    if (!(cosine > m_options.grazing)) // nor where it is not a number
        return std::nullopt;
    Sight sight{.place = m_camera.inCamera(sample.point)};
    const auto pixel = m_lens.project(sight.place);
    if (!pixel)
        return std::nullopt;
    sight.pixel = *pixel;
    const double border =
        std::min({pixel->x(), pixel->y(), m_camera.width - 1 - pixel->x(), m_camera.height - 1 - pixel->y()});
    if (!(border > 0))
        return std::nullopt;
    const Vec2d at =
        m_middle + Vec2d(m_camera.fx * sight.place.x(), m_camera.fy * sight.place.y()) / sight.place.z();
    const int x = static_cast<int>(std::lrint(at.x()));
    const int y = static_cast<int>(std::lrint(at.y()));
    if (x < 0 || y < 0 || x >= m_width || y >= m_height || m_planes[sample.triangle.value].distance >= 0 ||
        isHidden(sample, sight.place, x, y))
        return std::nullopt;
    // A pixel at an edge shows both sides of it, and so does what is interpolated between it and the next.
    sight.clearance = edgeDistance(at);
    const double fromEdge = (sight.clearance - 1) / m_options.edgeMargin;
    sight.trust = faded((cosine - m_options.grazing) / (m_options.facing - m_options.grazing)) *
                  faded(border / m_options.borderMargin) * faded(fromEdge);
    constexpr double least = 1e-6; // weights are of single precision
    if (!(sight.trust > least))
        return std::nullopt;
    sight.weight = sight.trust * std::pow(cosine, m_options.sharpness);
    return sight;
}

} // namespace quadrille
