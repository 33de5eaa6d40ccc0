// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/meshsequence.h"
#include "model/transition/framelayout.h"

#include <span>
#include <vector>

namespace quadrille {

/// The frames of all sequences of one character, by node; a value that shares what is heavy.
class CharacterFrames
{
public:
    /// \param sequences  in project order, each with at least one frame.
    /// \throws Error CharacterTopologyMismatch (other vertices or triangles than the first sequence),
    /// BadArgument (no frame).
    explicit CharacterFrames(std::span<const MeshSequence> sequences);

    const FrameLayout& layout() const { return m_layout; }
    std::span<const MeshSequence> sequences() const { return m_sequences; }
    NodeIndex frameCount() const { return m_layout.frameCount(); }
    std::uint32_t vertexCount() const;
    /// Empty without sequences.
    std::span<const Triangle> triangles() const;
    /// \throws Error as MeshSequence::frame.
    Frame frame(NodeIndex node) const;

private:
    std::vector<MeshSequence> m_sequences;
    FrameLayout m_layout;
};

} // namespace quadrille
