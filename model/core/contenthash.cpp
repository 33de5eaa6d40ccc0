// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/contenthash.h"

#include "model/core/error.h"
#include "model/core/file.h"

#include <algorithm>
#include <array>
#include <vector>
#include <xxhash.h>

namespace quadrille {

struct ContentHasher::State
{
    XXH3_state_t* xxh = XXH3_createState();
    State() { XXH3_128bits_reset(xxh); }
    ~State() { XXH3_freeState(xxh); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

ContentHasher::ContentHasher() : m_state(std::make_unique<State>()) {}

ContentHasher::~ContentHasher() = default;

void ContentHasher::addBytes(std::span<const std::byte> bytes)
{
    XXH3_128bits_update(m_state->xxh, bytes.data(), bytes.size());
}

void ContentHasher::add(std::string_view text)
{
    add(static_cast<std::int64_t>(text.size()));
    addBytes(std::as_bytes(std::span(text)));
}

void ContentHasher::add(std::int64_t number)
{
    std::array<std::byte, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes.at(i) = static_cast<std::byte>((static_cast<std::uint64_t>(number) >> (8 * i)) & 0xFFU);
    addBytes(bytes);
}

std::string ContentHasher::hex() const
{
    const XXH128_hash_t hash = XXH3_128bits_digest(m_state->xxh);
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, hash);
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : canonical.digest) {
        text += digits[byte >> 4U];
        text += digits[byte & 0xFU];
    }
    return text;
}

std::string hashFile(const std::filesystem::path& file, const Progress& progress)
{
    ContentHasher hasher;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && std::filesystem::file_size(file, error) == 0)
        return hasher.hex();
    const InputFile input(file);
    constexpr std::uint64_t chunk = std::uint64_t{4} << 20;
    std::vector<std::byte> buffer(std::min(chunk, input.size()));
    for (std::uint64_t at = 0; at < input.size(); at += chunk) {
        progress.report(static_cast<std::int64_t>(at), static_cast<std::int64_t>(input.size()));
        const auto part = std::span(buffer).first(std::min(chunk, input.size() - at));
        input.read(at, part);
        hasher.addBytes(part);
    }
    return hasher.hex();
}

} // namespace quadrille
