// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/framesource.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

MemoryFrames::MemoryFrames(std::vector<Vec3f> positions, std::uint32_t vertexCount)
    : m_positions(std::move(positions)), m_vertexCount(vertexCount)
{
    assert(vertexCount > 0 && m_positions.size() % vertexCount == 0);
}

std::int64_t MemoryFrames::frameCount() const
{
    return static_cast<std::int64_t>(m_positions.size() / m_vertexCount);
}

std::optional<Positions> MemoryFrames::view(FrameIndex frame) const
{
    return Positions(m_positions)
        .subspan(static_cast<std::size_t>(frame.value) * m_vertexCount, m_vertexCount);
}

void MemoryFrames::read(FrameIndex frame, MutablePositions out) const
{
    const auto positions = *view(frame);
    std::copy(positions.begin(), positions.end(), out.begin());
}

} // namespace quadrille
