// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/walks/fingerprints.h"

#include <utility>

namespace quadrille {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t mixed(std::uint64_t value)
{
    value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ULL;
    value = (value ^ (value >> 27)) * 0x94D049BB133111EBULL;
    return value ^ (value >> 31);
}

} // namespace

std::uint64_t fingerprintOf(std::initializer_list<std::int64_t> values)
{
    std::uint64_t result = 0;
    for (const std::int64_t value : values)
        result = mixed(result + 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(value));
    return result == 0 ? 1 : result;
}

std::size_t CheapestKnown::slotOf(std::uint64_t state) const
{
    const std::size_t mask = m_slots.size() - 1;
    std::size_t slot = state & mask;
    while (m_slots[slot].state != 0 && m_slots[slot].state != state)
        slot = (slot + 1) & mask;
    return slot;
}

void CheapestKnown::grow()
{
    const std::vector<Slot> old = std::exchange(m_slots, std::vector<Slot>(2 * m_slots.size()));
    for (const Slot& slot : old) {
        if (slot.state != 0)
            m_slots[slotOf(slot.state)] = slot;
    }
}

bool CheapestKnown::improves(std::uint64_t state, double cost)
{
    Slot* slot = &m_slots[slotOf(state)];
    if (slot->state == state) {
        if (cost >= slot->cost)
            return false;
        slot->cost = cost;
        return true;
    }
    if (2 * ++m_count > m_slots.size()) {
        grow();
        slot = &m_slots[slotOf(state)];
    }
    *slot = {state, cost};
    return true;
}

bool CheapestKnown::isWorse(std::uint64_t state, double cost) const
{
    const Slot& slot = m_slots[slotOf(state)];
    return slot.state == state && slot.cost < cost;
}

} // namespace quadrille
