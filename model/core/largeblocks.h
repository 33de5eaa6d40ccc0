// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace quadrille {

/// Memory for what is large, and comes and goes: the system hands pages out one by one where they are first
/// written to, which takes longer than decoding a picture does. From 2 MB on it comes in pages of as many,
/// where the system has them, and of what is freed some blocks are kept for the next of their size.
/// From any thread. \throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
/// \param bytes  as it was allocated with.
void freeLarge(void* block, std::size_t bytes) noexcept;
/// At most so much is kept of what is freed.
inline constexpr std::size_t keptBytes = std::size_t{64} << 20;
/// Gives back what is kept.
void releaseLargeBlocks() noexcept;

/// For containers of numbers that may be large, and come and go.
template <typename Value>
struct LargeBlocks
{
    using value_type = Value;

    LargeBlocks() = default;
    template <typename Other>
    LargeBlocks(const LargeBlocks<Other>&) noexcept
    {
    }

    Value* allocate(std::size_t count) { return static_cast<Value*>(allocateLarge(count * sizeof(Value))); }
    void deallocate(Value* values, std::size_t count) noexcept { freeLarge(values, count * sizeof(Value)); }
    bool operator==(const LargeBlocks&) const = default;
};

} // namespace quadrille
