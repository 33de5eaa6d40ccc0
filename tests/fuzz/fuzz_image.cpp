// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/error.h"
#include "model/core/image.h"

/// Anything but a picture or an Error is a bug.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    try {
        quadrille::decodeImage(std::as_bytes(std::span(data, size)), "fuzz");
    } catch (const quadrille::Error&) {
        return 0;
    }
    return 0;
}
