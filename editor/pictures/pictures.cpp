// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/pictures/pictures.h"

#include <utility>

namespace quadrille {

QImage toQImage(std::shared_ptr<const Image> image)
{
    if (!image || image->isEmpty())
        return {};
    const Image& pixels = *image;
    // The picture keeps the image alive.
    auto* owner = new std::shared_ptr<const Image>(std::move(image));
    return {pixels.pixels.data(),
            pixels.width,
            pixels.height,
            static_cast<qsizetype>(pixels.width) * 4,
            QImage::Format_RGBA8888,
            [](void* data) { delete static_cast<std::shared_ptr<const Image>*>(data); },
            owner};
}

QImage toQImage(Image image)
{
    return toQImage(std::make_shared<const Image>(std::move(image)));
}

} // namespace quadrille
