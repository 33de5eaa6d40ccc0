// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/live/bakedbytes.h"
#include "model/live/liveplayer.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>

namespace quadrille {

/// States of players as bytes: the same state is the same bytes. Refers to nothing. One thread at a time.
class LiveStateBytes
{
public:
    explicit LiveStateBytes(const LivePlayer& player);

    std::size_t size() const { return m_size; }
    /// Allocates nothing. \param out  of so many bytes.
    void write(const LiveState& state, void* out);
    /// \param bytes  so many. \return none where they are no state of such a player.
    std::optional<LiveState> read(const void* bytes) const;

private:
    std::shared_ptr<const LiveGraph> m_graph;
    BakedWriter m_writer;
    std::size_t m_size = 0;
};

} // namespace quadrille
