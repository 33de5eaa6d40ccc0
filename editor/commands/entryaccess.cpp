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

std::size_t memoryOf(const ExportEntry& entry)
{
    return sizeof(entry) + entry.name.capacity() + entry.what.capacity() + entry.path.capacity() +
           memoryOf(entry.unknown);
}

} // namespace quadrille
