// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/project/document/project.h"
#include "model/project/file/projectfile.h"
#include "model/sample/appearance.h"
#include "model/sample/entries.h"
#include "model/sample/groundtruth.h"
#include "model/sample/sample.h"
#include "model/sample/takes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace quadrille {

namespace {

namespace fs = std::filesystem;

std::string fileName(std::string name)
{
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

void writeObj(const Topology& topology, Positions rest, const fs::path& path)
{
    std::string text;
    char line[128];
    const auto add = [&](const char* format, auto... values) {
        text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, values...)));
    };
    for (const Vec3f& p : rest)
        add("v %.9g %.9g %.9g\n", static_cast<double>(p.x()), static_cast<double>(p.y()),
            static_cast<double>(p.z()));
    for (const Vec2f& uv : topology.data().uvs)
        add("vt %.9g %.9g\n", static_cast<double>(uv.x()), static_cast<double>(uv.y()));
    for (std::size_t t = 0; t < topology.triangles().size(); ++t) {
        const Triangle& v = topology.triangles()[t];
        const auto& uv = topology.data().triangleUvs[t];
        add("f %u/%u %u/%u %u/%u\n", v[0].value + 1, uv[0] + 1, v[1].value + 1, uv[1] + 1, v[2].value + 1,
            uv[2] + 1);
    }
    writeAtomically(path, text);
}

void writePc2(const MeshSequence& sequence, const fs::path& path)
{
    std::string bytes("POINTCACHE2\0", 12);
    const auto add = [&bytes](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    add(std::int32_t{1});
    add(static_cast<std::int32_t>(sequence.topology->vertexCount()));
    add(0.0F);
    add(1.0F);
    add(static_cast<std::int32_t>(sequence.frameCount()));
    for (std::int64_t f = 0; f < sequence.frameCount(); ++f) {
        const Frame frame = sequence.frame(FrameIndex(f));
        bytes.append(reinterpret_cast<const char*>(frame.positions().data()), frame.positions().size_bytes());
    }
    writeAtomically(path, bytes);
}

CharacterEntry writeBody(const SampleBody& body, const std::string& subfolder, const fs::path& folder)
{
    const std::string stem = subfolder + "/" + fileName(body.name);
    writeObj(*body.topology, body.rest, folder / (stem + ".obj"));
    writeImage(*body.texture, folder / (stem + ".png"));
    CharacterEntry entry;
    entry.name = body.name;
    entry.mesh = stem + ".obj";
    entry.texture = {TextureReference::Kind::Single, {stem + ".png"}};
    return entry;
}

/// The textures of single frames: one numbered JPEG each.
void writeTextures(const SampleCharacter& character, const SampleTake& take, const fs::path& folder,
                   const Progress& progress)
{
    const int size = take.appearance->textureSize;
    const TexelMap texels = mapTexels(character.body.topology->data(), size, 4);
    const SampleBody body = forTexturesOf(size, character.body);
    const std::int64_t frames = take.sequence.frameCount();
    std::atomic<std::int64_t> done{0};
    tbb::parallel_for(std::int64_t{0}, frames, [&](std::int64_t f) {
        progress.report(done++, frames);
        const Frame frame = take.sequence.frame(FrameIndex(f));
        const Image image = frameTexture(body, texels, frame.positions(), *take.appearance, FrameIndex(f));
        std::array<char, 16> name{};
        std::snprintf(name.data(), name.size(), "%04d.jpg", static_cast<int>(f));
        writeImage(image, folder / name.data(), 86);
    });
}

SequenceEntry writeTake(const SampleCharacter& character, const SampleTake& take, const fs::path& folder,
                        const Progress& progress)
{
    const std::string stem = fileName(take.sequence.name);
    SequenceEntry entry;
    entry.name = take.sequence.name;
    entry.character = character.body.name;
    entry.source = "takes/" + stem + ".pc2";
    entry.jointAngles = "takes/" + stem + ".bvh";
    entry.labels = take.sequence.labels;
    entry.contacts = take.sequence.contacts;
    progress.report(0);
    writePc2(take.sequence, folder / entry.source);
    writeAtomically(folder / entry.jointAngles, toBvh(character.skeleton, take.poses, take.sequence.fps));
    if (take.appearance) {
        const std::string textures = "textures/" + stem;
        entry.texture = {TextureReference::Kind::PerFrame, {textures}};
        writeTextures(character, take, folder / textures, progress);
        writeAtomically(folder / "groundtruth" / ("warps_" + stem + ".npy"), warpsNpy(*take.appearance));
    }
    return entry;
}

std::vector<SequenceEntry> writeTakes(const SampleCharacter& character, const fs::path& folder,
                                      const Progress& progress)
{
    std::vector<SequenceEntry> entries(character.takes.size());
    const auto count = static_cast<double>(entries.size());
    std::atomic<int> begun{0};
    tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t t) {
        const double from = begun++ / count;
        entries[t] = writeTake(character, character.takes[t], folder, progress.part(from, from + 1 / count));
    });
    return entries;
}

} // namespace

fs::path writeSample(const fs::path& folder, const SampleOptions& options, const Progress& progress)
{
    const SampleCharacter character = makeSampleCharacter(options, progress.part(0, 0.3));
    Project project;
    project.settings.fps = sampleFps;
    project.characters.resize(2);
    tbb::parallel_invoke(
        [&] { project.characters[0] = writeBody(character.body, "character", folder); },
        [&] { project.characters[1] = writeBody(character.target, "target", folder); },
        [&] { project.sequences = writeTakes(character, folder, progress.part(0.3, 0.98)); });
    project.characters[0].notes = "The built-in sample character.";
    project.characters[1].notes =
        "A second body, at rest, that performs a take of the first one; groundtruth/landmarks.json names "
        "places that belong together.";
    project.sequences.push_back(sampleBodyAtRest(project.characters[1]));
    project.transfers = {sampleTransfer(project.sequences.back().name)};
    project.graphs.resize(1);
    project.graphs[0].character = project.characters[0].name;
    project.animations = sampleAnimations(project.characters[0].name);
    project.bodyParts = {sampleBodyParts(character.body)};
    project.variations = sampleVariations(character);
    project.motionSpaces = sampleMotionSpaces(character);
    project.evaluations = sampleEvaluations(project.characters[0].name);
    project.exports = sampleExports();
    const fs::path truth = folder / "groundtruth";
    writeAtomically(truth / "skeleton.json", skeletonJson(character).dump() + "\n");
    writeAtomically(truth / "takes.json", takesJson(character).dump(1) + "\n");
    writeAtomically(truth / "landmarks.json", landmarksJson(character).dump(1) + "\n");
    fs::path file = folder / "sample.quadrille";
    saveProject(project, file);
    progress.report(1.0);
    return file;
}

} // namespace quadrille
