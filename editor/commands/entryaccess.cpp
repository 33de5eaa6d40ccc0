// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/commands/entryaccess.h"

namespace quadrille {

namespace {

std::size_t memoryOf(const TextureReference& texture)
{
    std::size_t bytes = 0;
    for (const std::string& path : texture.paths)
        bytes += sizeof(std::string) + path.capacity();
    return bytes;
}

std::size_t memoryOf(const UnknownKeys& keys)
{
    return keys.is_null() ? 0 : keys.dump().size() * 2;
}

} // namespace

std::size_t memoryOf(const ProjectSettings& settings)
{
    return sizeof(settings) + memoryOf(settings.unknown);
}

std::size_t memoryOf(const CharacterEntry& character)
{
    return sizeof(character) + character.name.capacity() + character.mesh.capacity() +
           character.notes.capacity() + memoryOf(character.texture) + memoryOf(character.unknown);
}

std::size_t memoryOf(const SequenceEntry& sequence)
{
    std::size_t bytes = sizeof(sequence) + sequence.name.capacity() + sequence.source.capacity() +
                        memoryOf(sequence.texture) + memoryOf(sequence.unknown);
    for (const LabelSpan& span : sequence.labels)
        bytes += sizeof(span) + span.label.capacity();
    for (const ContactSpan& span : sequence.contacts)
        bytes += sizeof(span) + span.foot.capacity();
    return bytes;
}

std::size_t memoryOf(const std::vector<GraphEntry>& graphs)
{
    std::size_t bytes = graphs.size() * sizeof(GraphEntry);
    for (const GraphEntry& graph : graphs)
        bytes += graph.character.capacity() + memoryOf(graph.unknown);
    return bytes;
}

std::size_t memoryOf(const AnimationEntry& animation)
{
    std::size_t bytes = sizeof(animation) + animation.name.capacity() + memoryOf(animation.unknown) +
                        animation.constraints.size() * sizeof(ConstraintEntry) +
                        (animation.junctions.banned.size() + animation.junctions.locked.size() +
                         animation.junctions.chosen.size()) *
                            sizeof(JunctionEntry);
    for (const ConstraintEntry& constraint : animation.constraints) {
        if (const auto* path = std::get_if<PathEntry>(&constraint))
            bytes += path->points.size() * sizeof(Vec3d) + path->spans.size() * sizeof(PathSpanEntry) +
                     path->obstacles.size() * sizeof(ObstacleEntry);
    }
    if (animation.walk)
        bytes += animation.walk->spans.size() * sizeof(WalkSpanEntry);
    if (animation.audio)
        bytes += animation.audio->file.capacity();
    bytes += animation.camera.size() * sizeof(CameraKeyEntry);
    return bytes;
}

std::size_t memoryOf(const std::vector<BodyPartsEntry>& bodies)
{
    std::size_t bytes = bodies.size() * sizeof(BodyPartsEntry);
    for (const BodyPartsEntry& body : bodies) {
        bytes += body.character.capacity() + body.parts.size() * sizeof(PartEntry) + memoryOf(body.unknown);
        for (const PartCurveEntry& curve : body.curves)
            bytes +=
                sizeof(curve) + (curve.curve.vertices.size() + curve.points.size()) * sizeof(VertexIndex);
    }
    return bytes;
}

std::size_t memoryOf(const VariationEntry& variation)
{
    std::size_t bytes = sizeof(variation) + variation.name.capacity() + memoryOf(variation.unknown) +
                        variation.training.size() * sizeof(TrainingEntry);
    for (const BlendEntry& blend : variation.blends)
        bytes += sizeof(blend) +
                 (blend.weights.size() + (blend.across ? blend.across->weights.size() : 0)) * sizeof(double);
    for (const SamplesEntry& samples : variation.samples)
        bytes += sizeof(samples) + samples.discarded.size() * sizeof(int);
    return bytes;
}

std::size_t memoryOf(const ExportEntry& entry)
{
    return sizeof(entry) + entry.name.capacity() + entry.what.capacity() + entry.path.capacity() +
           memoryOf(entry.unknown);
}

} // namespace quadrille
