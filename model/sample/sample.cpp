// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/sample/character.h"
#include "model/sample/perform.h"
#include "model/sample/texturebake.h"

#include <algorithm>

namespace quadrille {

namespace {

std::shared_ptr<const Topology> topologyOf(const SurfaceMesh& mesh, const Atlas& atlas)
{
    TopologyData data;
    data.vertexCount = static_cast<std::uint32_t>(mesh.points.size());
    data.triangles = mesh.triangles;
    data.uvs = atlas.uvs;
    data.triangleUvs = atlas.triangleUvs;
    return std::make_shared<const Topology>(std::move(data));
}

void makeTakes(SampleCharacter& character, const SurfaceMesh& mesh, const SampleOptions& options,
               const Progress& progress)
{
    const Performer performer{mesh, vertexNormals(mesh), character.skeleton, character.weights};
    const auto kinds = static_cast<std::int64_t>(takeKinds().size());
    for (std::int64_t k = 0; k < kinds; ++k) {
        const std::string& kind = takeKinds()[static_cast<std::size_t>(k)];
        const bool isRich = kind == "walk" || kind == "dance";
        const int count = std::min(options.takesPerKind + (isRich && options.takesPerKind > 1 ? 1 : 0), 3);
        for (int variant = 0; variant < count; ++variant) {
            progress.report(k, kinds);
            SampleRandom random(options.seed * 1000003 + static_cast<std::uint64_t>(k * 31 + variant));
            const TakeMotion motion = performTake(character.skeleton, kind, variant, random);
            SampleTake take;
            take.kind = kind;
            for (const Posture& posture : motion.frames)
                take.poses.push_back(solvePosture(character.skeleton, posture));
            take.flight = motion.flight;
            std::vector<Vec3f> frames = moveSurface(performer, take.poses, random.between(0, 6.28));
            const auto& topology = character.body.topology;
            take.sequence = makeSequence(
                kind + " " + std::to_string(variant + 1), topology,
                std::make_shared<MemoryFrames>(std::move(frames), topology->vertexCount()), sampleFps);
            take.sequence.textures = TextureSet::single({.embedded = character.body.texture});
            take.sequence.labels = motion.labels;
            take.sequence.contacts = contactsOf(motion.frames);
            character.takes.push_back(std::move(take));
        }
    }
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
    makeTakes(character, mesh, options, progress.part(0.6, 1.0));
    progress.report(1.0);
    return character;
}

} // namespace quadrille
