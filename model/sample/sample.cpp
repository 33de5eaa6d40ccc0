// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/core/error.h"
#include "model/sample/appearance.h"
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

SampleBody makeBody(const std::string& name, const Body& body, double spacing, double edgeScale,
                    int textureSize, const Palette& palette, SurfaceMesh& mesh, const Progress& progress)
{
    const SurfaceMesh half = extractHalfSurface(body, spacing, progress.part(0, 0.3));
    mesh = mirrorHalf(remeshHalf(half, body, edgeLengthFor(body, edgeScale), progress.part(0.3, 0.5)));
    SampleBody result;
    result.name = name;
    result.atlas = makeAtlas(mesh, body, progress.part(0.5, 0.6));
    result.topology = topologyOf(mesh, result.atlas);
    const TexelMap texels = mapTexels(result.atlas, textureSize, std::max(textureSize / 128, 2));
    result.texture =
        std::make_shared<const Image>(bakeTexture(mesh, body, texels, palette, progress.part(0.6, 1)));
    for (const Vec3d& p : mesh.points)
        result.rest.push_back(p.cast<float>());
    return result;
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
            Random random(options.seed * 1000003 + static_cast<std::uint64_t>(k * 31 + variant));
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
            take.sequence.contacts = contactsOf(motion);
            // Some takes of different kinds get a texture per frame; all of them would be large.
            if (variant == 0 && (kind == "walk" || kind == "reach low" || kind == "idle"))
                take.appearance = makeAppearance(take.sequence.frameCount(),
                                                 std::min(options.textureSize, 512), random.next());
            character.takes.push_back(std::move(take));
        }
    }
}

} // namespace

SampleCharacter makeSampleCharacter(const SampleOptions& options, const Progress& progress)
{
    if (options.textureSize < 64 || options.textureSize > 4096 || options.takesPerKind < 1 ||
        options.takesPerKind > 3)
        throw Error(
            ErrorCode::BadArgument,
            {{},
             {},
             {{"reason", "The sample needs a texture of 64 to 4096 texels and 1 to 3 takes of each kind"},
              {"remedy", "Choose other numbers."}}});
    SampleCharacter character;
    const Body body;
    SurfaceMesh mesh;
    character.body =
        makeBody("Quad", body, 0.005, 1.18, options.textureSize, {}, mesh, progress.part(0, 0.45));
    character.skeleton = makeSkeleton(body);
    character.weights = boneHeatWeights(mesh, character.skeleton);
    const Body target(targetProportions());
    SurfaceMesh targetMesh;
    character.target = makeBody("Otto", target, 0.0055, 0.98, options.textureSize, targetPalette(),
                                targetMesh, progress.part(0.45, 0.7));
    character.landmarks = makeLandmarks(body, mesh, target, targetMesh);
    makeTakes(character, mesh, options, progress.part(0.7, 1.0));
    progress.report(1.0);
    return character;
}

} // namespace quadrille
