// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/transition/framelayout.h"

#include <algorithm>
#include <cassert>

namespace quadrille {

FrameLayout::FrameLayout(std::span<const std::int64_t> counts)
{
    for (const std::int64_t count : counts) {
        assert(count >= 1);
        m_starts.push_back(m_starts.back() + static_cast<NodeIndex>(count));
    }
}

int FrameLayout::sequenceOf(NodeIndex frame) const
{
    assert(frame >= 0 && frame < frameCount());
    return static_cast<int>(std::upper_bound(m_starts.begin(), m_starts.end(), frame) - m_starts.begin()) - 1;
}

} // namespace quadrille
