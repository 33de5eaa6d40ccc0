// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"

#include <QImage>
#include <memory>

namespace quadrille {

/// The same pixels for Qt; null for null. Shared, not copied: the picture keeps the image alive.
QImage toQImage(std::shared_ptr<const Image> image);
/// \overload taking the pixels over.
QImage toQImage(Image image);
/// The same pixels for the model, opaque where Qt's have no alpha; empty for null.
Image toImage(const QImage& picture);

} // namespace quadrille
