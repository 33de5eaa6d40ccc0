// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/jpeg.h"

#include <memory>
#include <turbojpeg.h>

namespace quadrille {

namespace {

struct TurboJpegDeleter
{
    void operator()(void* handle) const { tjDestroy(handle); }
};
using TurboJpeg = std::unique_ptr<void, TurboJpegDeleter>;

struct TurboBufferDeleter
{
    void operator()(unsigned char* buffer) const { tjFree(buffer); }
};

} // namespace

std::optional<Image> decodeJpeg(std::span<const std::byte> encoded)
{
    const TurboJpeg turbo(tjInitDecompress());
    const auto* const bytes = reinterpret_cast<const unsigned char*>(encoded.data());
    int width = 0;
    int height = 0;
    int sampling = 0;
    int colours = 0;
    if (tjDecompressHeader3(turbo.get(), bytes, encoded.size(), &width, &height, &sampling, &colours) != 0)
        return std::nullopt;
    Image image(width, height);
    if (tjDecompress2(turbo.get(), bytes, encoded.size(), image.pixels.data(), width, 0, height, TJPF_RGBA,
                      TJFLAG_STOPONWARNING) != 0)
        return std::nullopt;
    return image;
}

std::optional<std::vector<std::byte>> encodeJpeg(const Image& image, int quality)
{
    const TurboJpeg turbo(tjInitCompress());
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    const int failed = tjCompress2(turbo.get(), image.pixels.data(), image.width, 0, image.height, TJPF_RGBX,
                                   &buffer, &size, TJSAMP_420, quality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, TurboBufferDeleter> owner(buffer);
    if (failed != 0)
        return std::nullopt;
    const auto* const bytes = reinterpret_cast<const std::byte*>(buffer);
    return std::vector<std::byte>(bytes, bytes + size);
}

} // namespace quadrille
