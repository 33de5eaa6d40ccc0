// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/renderframe.h"

#include "model/core/error.h"
#include "model/render/backdrop.h"
#include "model/render/mipmap.h"
#include "model/render/picture.h"
#include "model/render/shading.h"

#include <algorithm>
#include <string>

namespace quadrille {

namespace {

void check(const RenderOptions& options)
{
    const auto refuse = [](std::string reason, std::string remedy) {
        throw Error(ErrorCode::BadArgument,
                    {{}, {}, {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
    };
    constexpr int largest = 8192;
    if (options.width < 1 || options.height < 1 || options.width > largest || options.height > largest) {
        refuse("A picture of " + sizeText(options.width, options.height) + " pixels cannot be drawn",
               "Choose a width and height from 1 to " + std::to_string(largest) + ".");
    }
    if (options.supersampling < 1 || options.supersampling > 4)
        refuse("Pictures are drawn with 1 to 4 samples per pixel and direction", "Choose 2.");
}

bool needsTextures(const RenderOptions& options)
{
    return options.shading == RenderOptions::Shading::Textured ||
           options.shading == RenderOptions::Shading::Flat;
}

std::shared_ptr<const MipTexture> scaled(std::shared_ptr<const Image> image)
{
    return image && !image->isEmpty() ? std::make_shared<const MipTexture>(std::move(image)) : nullptr;
}

} // namespace

struct FrameRenderer::Shared
{
    IncidentTriangles neighbours;
    GroundPlane ground;
    double shadowTexel = 0.01;
    /// By material; empty when each frame has its own.
    std::vector<std::shared_ptr<const MipTexture>> textures;
};

Bounds boundsOf(const MeshSequence& sequence, std::int64_t samples, const Progress& progress)
{
    MediaCache none(0); // few of these frames are looked at again
    Bounds bounds;
    const std::int64_t frames = sequence.frameCount();
    const std::int64_t count = std::min(std::max<std::int64_t>(samples, 1), frames);
    for (std::int64_t i = 0; i < count; ++i) {
        progress.report(i, count);
        const std::int64_t frame = count > 1 ? i * (frames - 1) / (count - 1) : 0;
        bounds.add(boundsOf(sequence.frame(FrameIndex(frame), none).positions()));
    }
    return bounds;
}

FrameRenderer::FrameRenderer(MeshSequence sequence, const RenderOptions& options)
    : m_sequence(std::move(sequence)), m_options(options), m_shared(std::make_unique<Shared>())
{
    check(options);
    const Topology& topology = *m_sequence.topology;
    m_shared->neighbours = trianglesOfVertices(topology.triangles(), topology.vertexCount());
    m_shared->ground.up = options.axes.up;
    const Bounds bounds = boundsOf(m_sequence);
    const Eigen::Index up = m_shared->ground.vertical();
    if (!bounds.isEmpty()) {
        m_shared->ground.height = bounds.min[up];
        m_shared->shadowTexel = std::max(bounds.size()[up], 0.05 * bounds.size().maxCoeff()) / 160 + 1e-9;
    }
    m_shared->ground.height = options.groundHeight.value_or(m_shared->ground.height);
    const TextureSet& textures = m_sequence.textures;
    if (!topology.hasUvs() || !needsTextures(options) || textures.kind() == TextureSet::Kind::None ||
        textures.kind() == TextureSet::Kind::PerFrame)
        return;
    for (int material = 0; material < static_cast<int>(textures.textures().size()); ++material)
        m_shared->textures.push_back(scaled(textures.image(textures.indexFor(FrameIndex(0), material))));
}

FrameRenderer::~FrameRenderer() = default;

Image FrameRenderer::render(FrameIndex frame, const Camera& camera) const
{
    const Frame mesh = m_sequence.frame(frame);
    const Positions positions = mesh.positions();
    const Topology& topology = *m_sequence.topology;
    std::vector<std::shared_ptr<const MipTexture>> textures = m_shared->textures;
    if (topology.hasUvs() && needsTextures(m_options) &&
        m_sequence.textures.kind() == TextureSet::Kind::PerFrame)
        textures = {scaled(m_sequence.texture(frame))};

    const int samples = m_options.supersampling;
    const Projection projection(camera, m_options.width * samples, m_options.height * samples);
    const Lights lights(projection, m_options.axes.up);
    ShadowMap shadow;
    if (m_options.shadow) {
        shadow = ShadowMap(positions, topology.triangles(), m_shared->ground, lights.key().cast<double>(),
                           m_shared->shadowTexel);
    }
    const Backdrop backdrop(m_options, projection, camera, m_shared->ground, std::move(shadow));
    const std::vector<Vec3f> normals = vertexNormals(positions, topology.triangles(), m_shared->neighbours);
    return drawPicture({positions, normals, topology.data(), textures}, projection, lights, backdrop,
                       m_options);
}

Image renderFrame(const MeshSequence& sequence, FrameIndex frame, const Camera& camera,
                  const RenderOptions& options)
{
    return FrameRenderer(sequence, options).render(frame, camera);
}

} // namespace quadrille
