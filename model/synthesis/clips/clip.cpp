// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/clip.h"

namespace quadrille {

Positions Clip::frame(std::int64_t frame) const
{
    return Positions(positions).subspan(static_cast<std::size_t>(frame) * topology->vertexCount(),
                                        topology->vertexCount());
}

MutablePositions Clip::frame(std::int64_t frame)
{
    return MutablePositions(positions).subspan(static_cast<std::size_t>(frame) * topology->vertexCount(),
                                               topology->vertexCount());
}

} // namespace quadrille
