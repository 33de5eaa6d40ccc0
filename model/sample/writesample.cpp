// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/project/project.h"
#include "model/sample/sample.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>

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

} // namespace

fs::path writeSample(const fs::path& folder, const SampleOptions& options, const Progress& progress)
{
    const SampleCharacter character = makeSampleCharacter(options, progress.part(0, 0.8));
    Project project;
    project.settings.fps = character.takes.front().sequence.fps;
    const std::string name = fileName(character.body.name);
    writeObj(*character.body.topology, character.body.rest, folder / "character" / (name + ".obj"));
    writeImage(*character.body.texture, folder / "character" / (name + ".png"));
    CharacterEntry entry;
    entry.name = character.body.name;
    entry.mesh = "character/" + name + ".obj";
    entry.texture = {TextureReference::Kind::Single, {"character/" + name + ".png"}};
    project.characters.push_back(entry);
    for (const SampleTake& take : character.takes) {
        const std::string source = "takes/" + fileName(take.sequence.name) + ".pc2";
        writePc2(take.sequence, folder / source);
        SequenceEntry sequence;
        sequence.name = take.sequence.name;
        sequence.character = entry.name;
        sequence.source = source;
        sequence.labels = take.sequence.labels;
        sequence.contacts = take.sequence.contacts;
        project.sequences.push_back(sequence);
    }
    const fs::path file = folder / "sample.quadrille";
    saveProject(project, file);
    progress.report(1.0);
    return file;
}

} // namespace quadrille
