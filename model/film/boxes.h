// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace quadrille {

/// Numbers and texts one after the other, as films hold them; numbers begin with their highest byte.
class FilmBytes
{
public:
    /// \param bytes  1 … 8, the lowest so many of the value.
    FilmBytes& add(std::uint64_t value, int bytes)
    {
        for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
            m_text += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
        return *this;
    }
    FilmBytes& add8(std::uint64_t value) { return add(value, 1); }
    FilmBytes& add16(std::uint64_t value) { return add(value, 2); }
    FilmBytes& add32(std::uint64_t value) { return add(value, 4); }
    FilmBytes& add64(std::uint64_t value) { return add(value, 8); }
    /// The same with the lowest byte first.
    FilmBytes& addLittle(std::uint64_t value, int bytes)
    {
        for (int shift = 0; shift < 8 * bytes; shift += 8)
            m_text += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
        return *this;
    }
    FilmBytes& add(std::string_view text)
    {
        m_text += text;
        return *this;
    }
    FilmBytes& zeros(std::size_t count)
    {
        m_text.append(count, '\0');
        return *this;
    }
    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

/// A box of MP4 (ISO/IEC 14496-12): its size, its type, what is in it. \param type  four letters. \pre It
/// stays below 4 GB.
inline std::string box(std::string_view type, std::string_view content)
{
    return FilmBytes().add32(8 + content.size()).add(type).add(content).text();
}

/// A box with a version and flags. \param flags  the lowest 24 bits of them.
inline std::string fullBox(std::string_view type, int version, std::uint32_t flags, std::string_view content)
{
    return box(type, FilmBytes().add8(static_cast<std::uint64_t>(version)).add(flags, 3).add(content).text());
}

} // namespace quadrille
