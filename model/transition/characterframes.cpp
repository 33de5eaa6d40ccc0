// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/characterframes.h"

#include "model/core/error.h"

namespace quadrille {

namespace {

void requireSameTopology(const MeshSequence& first, const MeshSequence& sequence)
{
    const Topology& expected = *first.topology;
    const Topology& found = *sequence.topology;
    if (&expected == &found)
        return;
    std::string what;
    if (found.vertexCount() != expected.vertexCount())
        what =
            std::to_string(found.vertexCount()) + " vertices, not " + std::to_string(expected.vertexCount());
    else if (found.triangles().size() != expected.triangles().size())
        what = std::to_string(found.triangles().size()) + " triangles, not " +
               std::to_string(expected.triangles().size());
    else if (found.triangles() != expected.triangles())
        what = "its triangles have other corners";
    else
        return;
    throw Error(ErrorCode::CharacterTopologyMismatch,
                {.values = {{"sequence", sequence.name}, {"first", first.name}, {"what", what}}});
}

FrameLayout layoutOf(std::span<const MeshSequence> sequences)
{
    std::vector<std::int64_t> counts;
    for (const MeshSequence& sequence : sequences) {
        if (sequence.frameCount() < 1)
            throw Error(ErrorCode::BadArgument,
                        {.values = {{"reason", "“" + sequence.name + "” has no frame"},
                                    {"remedy", "Choose another range."}}});
        requireSameTopology(sequences.front(), sequence);
        counts.push_back(sequence.frameCount());
    }
    return FrameLayout(counts);
}

} // namespace

CharacterFrames::CharacterFrames(std::span<const MeshSequence> sequences)
    : m_sequences(sequences.begin(), sequences.end()), m_layout(layoutOf(sequences))
{
}

std::uint32_t CharacterFrames::vertexCount() const
{
    return m_sequences.empty() ? 0 : m_sequences.front().topology->vertexCount();
}

std::span<const Triangle> CharacterFrames::triangles() const
{
    return m_sequences.empty() ? std::span<const Triangle>() : m_sequences.front().topology->triangles();
}

Frame CharacterFrames::frame(NodeIndex node) const
{
    const int sequence = m_layout.sequenceOf(node);
    return m_sequences[static_cast<std::size_t>(sequence)].frame(
        FrameIndex(node - m_layout.firstOf(sequence)));
}

} // namespace quadrille
