// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// The font files, copied into the program by the assembler.
#include "model/render/fonts.h"

// clang-format off
#define QUADRILLE_EMBED(symbol, file)                                                                        \
    __asm__(".section .rodata\n"                                                                             \
            ".balign 16\n"                                                                                   \
            ".global " symbol "\n" symbol ":\n"                                                              \
            ".incbin \"" file "\"\n"                                                                         \
            ".global " symbol "End\n" symbol "End:\n"                                                        \
            ".byte 0\n"                                                                                      \
            ".previous\n")
// clang-format on
QUADRILLE_EMBED("quadrilleFontRegular", QUADRILLE_FONT_REGULAR);
QUADRILLE_EMBED("quadrilleFontBold", QUADRILLE_FONT_BOLD);

extern "C" {
[[gnu::visibility("hidden")]] extern const unsigned char quadrilleFontRegular[];
[[gnu::visibility("hidden")]] extern const unsigned char quadrilleFontRegularEnd[];
[[gnu::visibility("hidden")]] extern const unsigned char quadrilleFontBold[];
[[gnu::visibility("hidden")]] extern const unsigned char quadrilleFontBoldEnd[];
}

namespace quadrille {

std::span<const unsigned char> regularFont()
{
    return {quadrilleFontRegular, quadrilleFontRegularEnd};
}

std::span<const unsigned char> boldFont()
{
    return {quadrilleFontBold, quadrilleFontBoldEnd};
}

} // namespace quadrille
