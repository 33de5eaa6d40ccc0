// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/motionspaceentry.h"

#include <algorithm>

namespace quadrille {

std::size_t referenceOf(const MotionSpaceEntry& entry)
{
    const auto found = std::ranges::find(entry.takes, entry.reference, &SpaceTakeEntry::sequence);
    return found == entry.takes.end() ? 0 : static_cast<std::size_t>(found - entry.takes.begin());
}

bool isOfVertex(SpaceMeasure measure)
{
    return measure == SpaceMeasure::Height || measure == SpaceMeasure::Forward ||
           measure == SpaceMeasure::Side;
}

} // namespace quadrille
