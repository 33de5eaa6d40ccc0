// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/sample.h"

#include "model/core/error.h"
#include "model/sample/appearance.h"
#include "model/sample/figures.h"
#include "model/sample/perform.h"
#include "model/sample/surfacemesh.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

/// An image a whole number of times smaller: one texel of each square.
Image reduced(const Image& image, int size)
{
    const int factor = image.width / size;
    Image small(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            std::copy_n(image.pixel(factor * x + factor / 2, factor * y + factor / 2), 4, small.pixel(x, y));
    return small;
}

SampleBody bodyOf(SampleFigure figure, int textureSize)
{
    SampleBody body;
    body.name = std::move(figure.name);
    body.topology = std::make_shared<const Topology>(std::move(figure.faces));
    for (const Vec3d& p : figure.points)
        body.rest.push_back(p.cast<float>());
    body.texture = std::make_shared<const Image>(textureSize == figure.texture.width
                                                     ? std::move(figure.texture)
                                                     : reduced(figure.texture, textureSize));
    return body;
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
    if (options.textureSize < 64 || options.textureSize > 1024 ||
        !std::has_single_bit(static_cast<unsigned>(options.textureSize)) || options.takesPerKind < 1 ||
        options.takesPerKind > 3)
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", "The sample needs a texture of 64, 128, 256, 512 or 1024 texels and 1 to 3 "
                                 "takes of each kind"},
                      {"remedy", "Choose other numbers."}}});
    SampleFigures figures = shippedFigures();
    SampleCharacter character;
    const SurfaceMesh mesh{figures.character.points, figures.character.faces.triangles};
    character.body = bodyOf(std::move(figures.character), options.textureSize);
    character.target = bodyOf(std::move(figures.target), options.textureSize);
    character.skeleton = std::move(figures.skeleton);
    character.weights = std::move(figures.weights);
    character.landmarks = std::move(figures.landmarks);
    makeTakes(character, mesh, options, progress);
    progress.report(1.0);
    return character;
}

} // namespace quadrille
