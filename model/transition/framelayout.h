// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace quadrille {

/// Zero-based frame of a character: its sequences follow each other in project order.
using NodeIndex = std::int32_t;

/// Which frames of a character belong to which of its sequences. Empty sequences do not occur.
class FrameLayout
{
public:
    FrameLayout() = default;
    /// \param counts  frames of each sequence, in project order, each at least 1.
    explicit FrameLayout(std::span<const std::int64_t> counts);

    NodeIndex frameCount() const { return m_starts.back(); }
    int sequenceCount() const { return static_cast<int>(m_starts.size()) - 1; }
    /// First frame of a sequence.
    NodeIndex firstOf(int sequence) const { return m_starts[static_cast<std::size_t>(sequence)]; }
    /// Last frame of a sequence.
    NodeIndex lastOf(int sequence) const { return m_starts[static_cast<std::size_t>(sequence) + 1] - 1; }
    NodeIndex countOf(int sequence) const { return lastOf(sequence) - firstOf(sequence) + 1; }
    int sequenceOf(NodeIndex frame) const;
    bool operator==(const FrameLayout&) const = default;

private:
    std::vector<NodeIndex> m_starts{0}; ///< of each sequence, and where the next would start
};

} // namespace quadrille
