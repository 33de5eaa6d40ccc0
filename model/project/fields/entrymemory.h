// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"

#include <cstddef>

namespace quadrille {

/// Rough memory of a project or of an entry of a section, with all that it holds, bytes: what a history of
/// edits counts.
template <typename Entry>
std::size_t memoryOf(const Entry& entry);
template <typename Entry>
std::size_t memoryOf(const std::vector<Entry>& entries)
{
    std::size_t bytes = 0;
    for (const Entry& entry : entries)
        bytes += memoryOf(entry);
    return bytes;
}

} // namespace quadrille
