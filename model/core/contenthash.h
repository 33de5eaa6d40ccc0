// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace quadrille {

/// Builds a 128-bit hash (XXH3) of content; not meant against forgery.
class ContentHasher
{
public:
    ContentHasher();
    ~ContentHasher();
    ContentHasher(const ContentHasher&) = delete;
    ContentHasher& operator=(const ContentHasher&) = delete;

    void addBytes(std::span<const std::byte> bytes);
    /// Adds the text with its length, so that two texts in a row differ from their concatenation.
    void add(std::string_view text);
    void add(std::int64_t number);
    /// 32 hexadecimal digits of all that was added so far.
    std::string hex() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

/// Hash of a file's content, as ContentHasher::hex.
/// \throws Error what InputFile throws (an empty file has a hash, too), Cancelled.
std::string hashFile(const std::filesystem::path& file, const Progress& progress = {});

} // namespace quadrille
