// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/core/error.h"
#include "model/sample/appearance.h"
#include "model/sample/character.h"
#include "model/sample/perform.h"
#include "model/sample/texturebake.h"

#include <algorithm>
#include <atomic>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

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

/// The kind of a take by its place among the kinds, and which one of the kind it is.
struct TakePlace
{
    std::size_t kind = 0;
    int variant = 0;
};

std::vector<TakePlace> takePlaces(int takesPerKind)
{
    std::vector<TakePlace> places;
    for (std::size_t k = 0; k < takeKinds().size(); ++k) {
        const std::string& kind = takeKinds()[k];
        const bool isRich = kind == "walk" || kind == "dance";
        const int count = std::min(takesPerKind + (isRich && takesPerKind > 1 ? 1 : 0), 3);
        for (int variant = 0; variant < count; ++variant)
            places.push_back({k, variant});
    }
    return places;
}

SampleTake makeTake(const SampleCharacter& character, const Performer& performer, const TakePlace& place,
                    const SampleOptions& options)
{
    const std::string& kind = takeKinds()[place.kind];
    const auto stream =
        static_cast<std::uint64_t>(place.kind * 31) + static_cast<std::uint64_t>(place.variant);
    Random random(options.seed * 1000003 + stream);
    const TakeMotion motion = performTake(character.skeleton, kind, place.variant, random);
    SampleTake take;
    take.kind = kind;
    for (const Posture& posture : motion.frames)
        take.poses.push_back(solvePosture(character.skeleton, posture));
    take.flight = motion.flight;
    std::vector<Vec3f> frames = moveSurface(performer, take.poses, random.between(0, 6.28));
    const auto& topology = character.body.topology;
    take.sequence =
        makeSequence(kind + " " + std::to_string(place.variant + 1), topology,
                     std::make_shared<MemoryFrames>(std::move(frames), topology->vertexCount()), sampleFps);
    take.sequence.textures = TextureSet::single({.embedded = character.body.texture});
    take.sequence.labels = motion.labels;
    take.sequence.contacts = contactsOf(motion);
    // Some takes of different kinds get a texture per frame; all of them would be large.
    if (place.variant == 0 && (kind == "walk" || kind == "reach low" || kind == "idle"))
        take.appearance =
            makeAppearance(take.sequence.frameCount(), std::min(options.textureSize, 512), random.next());
    return take;
}

void makeTakes(SampleCharacter& character, const SurfaceMesh& mesh, const SampleOptions& options,
               const Progress& progress)
{
    const Performer performer{mesh, vertexNormals(mesh), character.skeleton, character.weights};
    const std::vector<TakePlace> places = takePlaces(options.takesPerKind);
    character.takes.resize(places.size());
    std::atomic<std::int64_t> done{0};
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t t) {
        progress.report(done++, static_cast<std::int64_t>(places.size()));
        character.takes[t] = makeTake(character, performer, places[t], options);
    });
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
    const Body target(targetProportions());
    SurfaceMesh targetMesh;
    // Much of it goes one step after the other: the two bodies side by side.
    const Progress bodies = progress.part(0, 0.7);
    tbb::parallel_invoke(
        [&] {
            character.body = makeBody("Quad", body, 0.005, 1.18, options.textureSize, {}, mesh, bodies);
            character.skeleton = makeSkeleton(body);
            character.weights = boneHeatWeights(mesh, character.skeleton);
        },
        [&] {
            character.target = makeBody("Otto", target, 0.0055, 0.98, options.textureSize, targetPalette(),
                                        targetMesh, bodies);
        });
    character.landmarks = makeLandmarks(body, mesh, target, targetMesh);
    makeTakes(character, mesh, options, progress.part(0.7, 1.0));
    progress.report(1.0);
    return character;
}

} // namespace quadrille
