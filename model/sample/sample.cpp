// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/sample/character.h"
#include "model/sample/gait.h"
#include "model/sample/texturebake.h"

namespace quadrille {

namespace {

constexpr double fps = 25;

std::shared_ptr<const Topology> topologyOf(const SurfaceMesh& mesh, const Atlas& atlas)
{
    TopologyData data;
    data.vertexCount = static_cast<std::uint32_t>(mesh.points.size());
    data.triangles = mesh.triangles;
    data.uvs = atlas.uvs;
    data.triangleUvs = atlas.triangleUvs;
    return std::make_shared<const Topology>(std::move(data));
}

} // namespace

SampleCharacter makeSampleCharacter(const SampleOptions& options, const Progress& progress)
{
    SampleCharacter character;
    const Body body;
    const SurfaceMesh half = remeshHalf(extractHalfSurface(body, 0.005, progress.part(0, 0.1)), body,
                                        edgeLengthFor(body, 1.09), progress.part(0.1, 0.2));
    const SurfaceMesh mesh = mirrorHalf(half);
    character.body.name = "Quad";
    character.body.atlas = makeAtlas(mesh, body, progress.part(0.2, 0.25));
    character.body.topology = topologyOf(mesh, character.body.atlas);
    const TexelMap texels = mapTexels(character.body.atlas, options.textureSize, options.textureSize / 128);
    character.body.texture =
        std::make_shared<const Image>(bakeTexture(mesh, body, texels, {}, progress.part(0.25, 0.6)));
    for (const Vec3d& p : mesh.points)
        character.body.rest.push_back(p.cast<float>());
    character.skeleton = makeSkeleton(body);
    character.weights = boneHeatWeights(mesh, character.skeleton);
    const GaitMotion walk = makeGait(character.skeleton, {.duration = 2.4}, fps);
    SampleTake take;
    take.kind = "walk";
    std::vector<Vec3f> frames;
    std::vector<Vec3d> skinned;
    for (const Posture& posture : walk.frames) {
        take.poses.push_back(solvePosture(character.skeleton, posture));
        skin(mesh.points, character.weights, character.skeleton,
             worldJoints(character.skeleton, take.poses.back()), skinned);
        for (const Vec3d& p : skinned)
            frames.push_back(p.cast<float>());
    }
    take.sequence = makeSequence(
        "walk 1", character.body.topology,
        std::make_shared<MemoryFrames>(std::move(frames), character.body.topology->vertexCount()), fps);
    take.sequence.textures = TextureSet::single({.embedded = character.body.texture});
    take.sequence.labels = {{"walk", FrameRange::all(take.sequence.frameCount())}};
    character.takes.push_back(std::move(take));
    progress.report(1.0);
    return character;
}

} // namespace quadrille
