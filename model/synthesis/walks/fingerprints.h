// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace quadrille {

/// 64 bits that stand for values; never 0.
std::uint64_t fingerprintOf(std::initializer_list<std::int64_t> values);

/// The least cost at which each state is known, by its fingerprint.
class CheapestKnown
{
public:
    /// Whether the state is new or cheaper than before; it is then known at this cost.
    bool improves(std::uint64_t state, double cost);
    /// Whether the state is known at less.
    bool isWorse(std::uint64_t state, double cost) const;
    /// States that are known.
    std::size_t count() const { return m_count; }

private:
    struct Slot
    {
        std::uint64_t state = 0; ///< 0: empty
        double cost = 0;
    };
    std::size_t slotOf(std::uint64_t state) const;
    void grow();

    std::vector<Slot> m_slots = std::vector<Slot>(1024);
    std::size_t m_count = 0;
};

} // namespace quadrille
