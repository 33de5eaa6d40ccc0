// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/textureprojector.h"

#include "model/core/badargument.h"
#include "model/render/color.h"
#include "model/render/mipmap.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quadrille {

namespace {

using StepWeights = Eigen::Matrix2d;

/// How the weights of a triangle's second and third corner change from texel to texel; zero where it has no
/// area.
StepWeights stepWeights(const std::array<Vec2d, 3>& uvs, int width, int height)
{
    Eigen::Matrix2d edges;
    edges.col(0) = uvs[1] - uvs[0];
    edges.col(1) = uvs[2] - uvs[0];
    const double area = edges.determinant();
    if (!(std::abs(area) > 1e-18))
        return StepWeights::Zero();
    return edges.inverse() * Eigen::Vector2d(1.0 / width, -1.0 / height).asDiagonal();
}

/// A texel in space.
struct TexelOnSurface
{
    SurfaceSample sample;
    std::array<Vec3d, 2> steps; ///< in space, to the texels to the right and below
};

TexelOnSurface onSurface(const AtlasTexels::Place& place, const Triangle& corners, Positions positions,
                         std::span<const Vec3f> normals, const StepWeights& steps)
{
    const Vec3d weights(1 - double{place.weights.x()} - double{place.weights.y()}, double{place.weights.x()},
                        double{place.weights.y()});
    std::array<Vec3d, 3> p;
    Vec3d normal = Vec3d::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
        p[c] = positions[corners[c].value].cast<double>();
        normal += weights[static_cast<Eigen::Index>(c)] * normals[corners[c].value].cast<double>();
    }
    const Vec3d first = p[1] - p[0];
    const Vec3d second = p[2] - p[0];
    return {{p[0] + weights.y() * first + weights.z() * second, normal.normalized(), place.triangle},
            {Vec3d(first * steps(0, 0) + second * steps(1, 0)),
             Vec3d(first * steps(0, 1) + second * steps(1, 1))}};
}

/// How far a step in space goes in the picture, pixels; the lens's distortion is left out.
Vec2f pixelsAlong(const PinholeCamera& camera, const Vec3d& place, const Vec3d& step)
{
    const Vec3d d = camera.rotation * step;
    const double nearness = 1 / place.z();
    return Vec2d(camera.fx * (d.x() - place.x() * nearness * d.z()) * nearness,
                 camera.fy * (d.y() - place.y() * nearness * d.z()) * nearness)
        .cast<float>();
}

/// The coarsest level whose samples do not reach over an edge. They take in one and a half texels of the
/// level above it, which are twice as large.
float coarsestNear(double clearance)
{
    return static_cast<float>(std::log2(std::max(clearance / 3, 1.0)));
}

} // namespace

/// Weighted sums of all cameras so far.
class TextureProjector::Sums
{
public:
    struct Texel
    {
        Vec3f light = Vec3f::Zero();
        float weight = 0;
        float trust = 0;
        std::uint16_t cameras = 0;
    };

    Sums(std::size_t texelCount, std::size_t cameraCount)
        : texels(texelCount), weights(cameraCount, std::vector<float>(texelCount))
    {
    }

    ProjectedTexels blended() const
    {
        const SrgbTables& tables = SrgbTables::instance();
        ProjectedTexels projected{.colours = std::vector<ProjectedTexels::Colour>(texels.size()),
                                  .shares = std::vector<double>(weights.size())};
        for (std::size_t t = 0; t < texels.size(); ++t) {
            const Texel& sum = texels[t];
            if (sum.cameras == 0)
                continue;
            const Vec3f light = sum.light / sum.weight;
            projected.colours[t] = {
                tables.toSrgb(light.x()), tables.toSrgb(light.y()), tables.toSrgb(light.z()),
                static_cast<std::uint8_t>(std::clamp(std::lrint(255 * sum.trust), 1L, 255L))};
            ++projected.seen;
            projected.sights += sum.cameras;
            for (std::size_t c = 0; c < weights.size(); ++c)
                projected.shares[c] += double{weights[c][t] / sum.weight};
        }
        for (double& share : projected.shares)
            share /= static_cast<double>(std::max<std::int64_t>(projected.seen, 1));
        return projected;
    }

    std::vector<Texel> texels;
    std::vector<std::vector<float>> weights; ///< per camera and texel
};

TextureProjector::TextureProjector(std::shared_ptr<const Topology> topology,
                                   std::vector<PinholeCamera> cameras, int width, int height,
                                   const SightOptions& options)
    : m_topology(std::move(topology))
    , m_cameras(std::move(cameras))
    , m_options(options)
    , m_atlas(atlasTexels(*m_topology, width, height))
    , m_neighbours(trianglesOfVertices(m_topology->triangles(), m_topology->vertexCount()))
{
    for (const PinholeCamera& camera : m_cameras) {
        if (const auto fault = faultOf(camera))
            refuse("The camera “" + camera.name + "” cannot be used. " + fault->reason, fault->remedy);
    }
    const TopologyData& data = m_topology->data();
    m_steps.reserve(data.triangleUvs.size());
    for (const auto& corners : data.triangleUvs) {
        std::array<Vec2d, 3> uvs;
        for (std::size_t c = 0; c < 3; ++c)
            uvs[c] = data.uvs[corners[c]].cast<double>();
        m_steps.push_back(stepWeights(uvs, width, height));
    }
}

void TextureProjector::addCamera(std::size_t camera, Positions positions, std::span<const Vec3f> normals,
                                 const std::shared_ptr<const Image>& picture, Sums& sums,
                                 const Progress& progress) const
{
    const PinholeCamera& own = m_cameras[camera];
    if (picture->width != own.width || picture->height != own.height)
        refuse("A picture of the camera “" + own.name + "” has " + sizeText(picture->width, picture->height) +
                   " pixels and not " + sizeText(own.width, own.height),
               "Scale the pictures, or calibrate the camera for their size.");
    const CameraView view(own, positions, m_topology->triangles(), m_options);
    progress.report(0.4);
    const MipTexture scaled(picture);
    progress.report(0.5);
    const SrgbTables& tables = SrgbTables::instance();
    constexpr std::size_t atOnce = 4096;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, m_atlas.places.size(), atOnce), [&](const auto& range) {
            progress.report(0.5);
            for (std::size_t t = range.begin(); t != range.end(); ++t) {
                const AtlasTexels::Place& place = m_atlas.places[t];
                const TexelOnSurface texel = onSurface(place, m_topology->triangles()[place.triangle.value],
                                                       positions, normals, m_steps[place.triangle.value]);
                const auto sight = view.sightOf(texel.sample);
                if (!sight)
                    continue;
                // A sample reaches over two texels of its level: those of half the size do.
                const float size = MipTexture::levelFor(pixelsAlong(own, sight->place, texel.steps[0]),
                                                        pixelsAlong(own, sight->place, texel.steps[1])) -
                                   1;
                const float level = std::min(size, coarsestNear(sight->clearance));
                const Vec2f at(static_cast<float>((sight->pixel.x() + 0.5) / own.width),
                               static_cast<float>(1 - (sight->pixel.y() + 0.5) / own.height));
                const auto weight = static_cast<float>(sight->weight);
                Sums::Texel& sum = sums.texels[t];
                sum.light += weight * tables.toLinear(scaled.sample(at, level));
                sum.weight += weight;
                sum.trust = std::max(sum.trust, static_cast<float>(sight->trust));
                ++sum.cameras;
                sums.weights[camera][t] = weight;
            }
        });
}

ProjectedTexels TextureProjector::project(Positions positions,
                                          std::span<const std::shared_ptr<const Image>> pictures,
                                          const Progress& progress) const
{
    if (positions.size() != m_topology->vertexCount() || pictures.size() != m_cameras.size())
        refuse("Vertices or pictures are not as many as the mesh and the cameras have", "Give one for each.");
    if (!std::ranges::all_of(positions, [](const Vec3f& p) { return p.allFinite(); }))
        refuse("Not all vertices have finite coordinates", "Repair the frame.");
    // Whoever waits here shall not begin another frame, which takes memory of its own.
    return tbb::this_task_arena::isolate([&] {
        const std::vector<Vec3f> normals = vertexNormals(positions, m_topology->triangles(), m_neighbours);
        Sums sums(m_atlas.places.size(), m_cameras.size());
        for (std::size_t c = 0; c < m_cameras.size(); ++c) {
            const auto count = static_cast<double>(m_cameras.size());
            const double done = static_cast<double>(c);
            progress.report(done / count);
            if (pictures[c] != nullptr)
                addCamera(c, positions, normals, pictures[c], sums,
                          progress.part(done / count, (done + 1) / count));
        }
        return sums.blended();
    });
}

} // namespace quadrille
