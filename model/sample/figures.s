# SPDX-FileCopyrightText: 2026 The Quadrille developers
# SPDX-License-Identifier: MIT
# The bodies at rest, built into the library so that it needs no files beside it (read in figures.cpp).
    .macro embed name, file
    .globl \name
    .globl \name\()End
    .balign 8
\name:
    .incbin "\file"
\name\()End:
    .endm

    .section .rodata
    embed quadrilleFigures, resources/sample/body/figures.cbor
    embed quadrilleQuadTexture, resources/sample/body/Quad.png
    embed quadrilleOttoTexture, resources/sample/body/Otto.png

    .section .note.GNU-stack, "", %progbits
