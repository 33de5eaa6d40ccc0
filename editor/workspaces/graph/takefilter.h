// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace quadrille {

/// Which takes of a character are looked at: of one, all transitions that leave it or arrive there; of
/// several, those among them.
struct TakeFilter
{
    std::vector<int> takes; ///< places in the character's layout; empty: all takes

    bool isEmpty() const { return takes.empty(); }
    bool has(int take) const { return takes.empty() || std::ranges::find(takes, take) != takes.end(); }
    /// Whether transitions from one take to another are looked at.
    bool passes(int from, int to) const
    {
        return takes.size() == 1 ? has(from) || has(to) : has(from) && has(to);
    }
    bool operator==(const TakeFilter&) const = default;
};

} // namespace quadrille
