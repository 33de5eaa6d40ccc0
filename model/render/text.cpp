// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/text.h"

#include "model/render/fonts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ft2build.h>
#include <new>
#include <vector>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace quadrille {

namespace {

/// FreeType's objects belong to one thread.
class Fonts
{
public:
    Fonts()
    {
        if (FT_Init_FreeType(&m_library) != 0)
            throw std::bad_alloc();
        open(regularFont(), m_regular);
        open(boldFont(), m_bold);
    }
    ~Fonts() { FT_Done_FreeType(m_library); }
    Fonts(const Fonts&) = delete;
    Fonts& operator=(const Fonts&) = delete;

    static Fonts& ofThisThread()
    {
        thread_local Fonts fonts;
        return fonts;
    }

    FT_Face face(const TextStyle& style)
    {
        FT_Face face = style.isBold ? m_bold : m_regular;
        FT_Set_Char_Size(face, 0, std::lrint(style.size * 64), 72, 72);
        return face;
    }

private:
    void open(std::span<const unsigned char> file, FT_Face& face)
    {
        if (FT_New_Memory_Face(m_library, file.data(), static_cast<FT_Long>(file.size()), 0, &face) != 0)
            throw std::bad_alloc();
    }

    FT_Library m_library = nullptr;
    FT_Face m_regular = nullptr;
    FT_Face m_bold = nullptr;
};

/// The length of the UTF-8 sequence that a byte begins; 1 for bytes that begin none.
std::size_t sequenceLength(unsigned char lead)
{
    return lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC0 ? 2 : 1;
}

/// Code points; U+FFFD where the text is not UTF-8.
std::vector<FT_ULong> codePoints(std::string_view utf8)
{
    std::vector<FT_ULong> points;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        const std::size_t length = sequenceLength(lead);
        FT_ULong point = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        bool valid = (lead < 0x80 || length > 1) && i + length <= utf8.size();
        for (std::size_t k = 1; valid && k < length; ++k) {
            const auto byte = static_cast<unsigned char>(utf8[i + k]);
            valid = (byte & 0xC0U) == 0x80U;
            point = point << 6U | (byte & 0x3FU);
        }
        points.push_back(valid ? point : 0xFFFDU);
        i += valid ? length : 1;
    }
    return points;
}

/// Calls visit(glyph index, x) for each character; x in 1/64 pixel from the beginning.
/// \return the width, 1/64 pixel.
template <typename Visit>
FT_Pos layOut(FT_Face face, std::string_view utf8, const Visit& visit)
{
    FT_Pos x = 0;
    FT_UInt previous = 0;
    for (const FT_ULong point : codePoints(utf8)) {
        const FT_UInt glyph = FT_Get_Char_Index(face, point);
        FT_Vector kerning = {0, 0};
        if (previous != 0 && glyph != 0)
            FT_Get_Kerning(face, previous, glyph, FT_KERNING_UNFITTED, &kerning);
        x += kerning.x;
        FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP);
        const FT_Pos advance = face->glyph->linearHoriAdvance >> 10; // 16.16 → 26.6
        visit(glyph, x);
        x += advance;
        previous = glyph;
    }
    return x;
}

void blend(Image& image, const FT_Bitmap& bitmap, std::int64_t left, std::int64_t top, std::uint32_t color)
{
    const std::array<int, 3> ink = {static_cast<int>(color >> 16U & 0xFFU),
                                    static_cast<int>(color >> 8U & 0xFFU), static_cast<int>(color & 0xFFU)};
    for (std::int64_t row = 0; row < bitmap.rows; ++row) {
        for (std::int64_t column = 0; column < bitmap.width; ++column) {
            const std::int64_t x = left + column;
            const std::int64_t y = top + row;
            if (x < 0 || y < 0 || x >= image.width || y >= image.height)
                continue;
            const int cover = bitmap.buffer[row * bitmap.pitch + column];
            std::uint8_t* pixel = image.pixel(static_cast<int>(x), static_cast<int>(y));
            for (std::size_t i = 0; i < 3; ++i)
                pixel[i] = static_cast<std::uint8_t>((pixel[i] * (255 - cover) + ink[i] * cover + 127) / 255);
            pixel[3] = static_cast<std::uint8_t>(std::max<int>(pixel[3], cover));
        }
    }
}

} // namespace

double textWidth(std::string_view utf8, const TextStyle& style)
{
    const FT_Pos width = layOut(Fonts::ofThisThread().face(style), utf8, [](FT_UInt, FT_Pos) {});
    return static_cast<double>(width) / 64;
}

void drawText(Image& image, std::string_view utf8, double x, double baseline, const TextStyle& style)
{
    FT_Face face = Fonts::ofThisThread().face(style);
    const FT_Pos start = std::lrint(x * 64);
    const std::int64_t line = std::lrint(baseline);
    layOut(face, utf8, [&](FT_UInt, FT_Pos offset) {
        FT_GlyphSlot slot = face->glyph;
        const FT_Pos at = start + offset;
        FT_Outline_Translate(&slot->outline, at & 63, 0);
        if (FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL) == 0)
            blend(image, slot->bitmap, (at >> 6) + slot->bitmap_left, line - slot->bitmap_top, style.color);
    });
}

std::string elided(std::string_view utf8, double width, const TextStyle& style)
{
    if (textWidth(utf8, style) <= width)
        return std::string(utf8);
    std::string_view kept = utf8;
    while (!kept.empty()) {
        do {
            kept.remove_suffix(1);
        } while (!kept.empty() && (static_cast<unsigned char>(utf8[kept.size()]) & 0xC0U) == 0x80U);
        std::string shortened = std::string(kept) + "…";
        if (textWidth(shortened, style) <= width)
            return shortened;
    }
    return {};
}

} // namespace quadrille
