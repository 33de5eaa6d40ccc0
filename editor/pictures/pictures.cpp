// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/pictures/pictures.h"

#include <cstring>
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

Image toImage(const QImage& picture)
{
    if (picture.isNull())
        return {};
    const QImage source = picture.convertToFormat(QImage::Format_RGBA8888);
    Image image(source.width(), source.height());
    const auto bytesPerRow = static_cast<std::size_t>(source.width()) * 4;
    for (int y = 0; y < source.height(); ++y)
        std::memcpy(image.pixel(0, y), source.constScanLine(y), bytesPerRow);
    return image;
}

} // namespace quadrille
