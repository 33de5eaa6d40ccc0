// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// How a texture view draws.
#include "widgets/controls/textureview.h"
#include "widgets/theme/theme.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr int smallestHalf = 128; // pixels
constexpr double gridZoom = 8;    // logical pixels for each of the texture from which the grid is drawn
constexpr double checkerSize = 8; // logical pixels
constexpr qsizetype mostLines = 100'000;
constexpr double crowdedEdge = 10; // mean length in logical pixels below which edges would hide the texture

void paintChecker(QPainter& painter, const QRectF& place)
{
    QPixmap tile(QSize(2, 2) * static_cast<int>(checkerSize));
    tile.fill(Theme::color(ColorRole::Base));
    QPainter tilePainter(&tile);
    const QColor other = Theme::color(ColorRole::Raised);
    tilePainter.fillRect(QRectF(0, 0, checkerSize, checkerSize), other);
    tilePainter.fillRect(QRectF(checkerSize, checkerSize, checkerSize, checkerSize), other);
    tilePainter.end();
    painter.drawTiledPixmap(place, tile, place.topLeft());
}

} // namespace

TexturePicture prepareTexture(const QImage& image)
{
    TexturePicture picture{image, {}};
    QImage next = image;
    while (std::max(next.width(), next.height()) >= 2 * smallestHalf) {
        if (picture.halves.empty())
            next = next.convertToFormat(QImage::Format_ARGB32_Premultiplied);
        next = next.scaled(std::max(1, next.width() / 2), std::max(1, next.height() / 2),
                           Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        picture.halves.push_back(next);
    }
    return picture;
}

void TextureView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.fillRect(rect(), Theme::color(ColorRole::Window));
    if (!isEmpty())
        paintContent(painter);
    if (hasFocus()) {
        painter.setPen(Theme::color(ColorRole::Accent));
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    }
}

void TextureView::paintContent(QPainter& painter)
{
    paintChecker(painter, textureRect().intersected(QRectF(rect())));
    if (!m_picture.image.isNull())
        paintPicture(painter, m_picture);
    paintOver(painter);
    if (m_scale >= gridZoom && !m_picture.image.isNull())
        paintPixelGrid(painter);
    painter.setPen(QPen(Theme::color(ColorRole::Line), 0));
    painter.drawRect(
        textureRect().adjusted(-0.5, -0.5, 0.5, 0.5).intersected(QRectF(rect()).adjusted(-2, -2, 2, 2)));
    if (!m_edges.isEmpty()) {
        updateEdgeImage();
        painter.drawImage(QPointF(), m_edgeImage);
    }
}

/// Draws only what is seen: coordinates beyond the view would be too large for the painter.
void TextureView::paintPicture(QPainter& painter, const TexturePicture& picture) const
{
    const double reduction = 1 / zoom();
    const auto wanted = static_cast<std::size_t>(reduction < 2 ? 0.0 : std::floor(std::log2(reduction)));
    const std::size_t level = std::min(wanted, picture.halves.size());
    const QImage& image = level == 0 ? picture.image : picture.halves[level - 1];
    const QRectF place = textureRect();
    const double across = image.width() / place.width();
    const double down = image.height() / place.height();
    const QRectF seen = place.intersected(QRectF(rect()));
    const QRectF source((seen.left() - place.left()) * across, (seen.top() - place.top()) * down,
                        seen.width() * across, seen.height() * down);
    const QRect whole = source.toAlignedRect().intersected(image.rect());
    const QRectF target(place.left() + whole.left() / across, place.top() + whole.top() / down,
                        whole.width() / across, whole.height() / down);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom() < 2);
    painter.drawImage(target, image, QRectF(whole));
}

void TextureView::paintPixelGrid(QPainter& painter) const
{
    const QRectF seen = textureRect().intersected(QRectF(rect()));
    const QPoint first = pixelAt(seen.topLeft());
    const QPoint last = pixelAt(seen.bottomRight());
    QList<QLineF> lines;
    for (int x = first.x() + 1; x <= last.x(); ++x) {
        const double at = m_origin.x() + x * m_scale;
        lines += QLineF(at, seen.top(), at, seen.bottom());
    }
    for (int y = first.y() + 1; y <= last.y(); ++y) {
        const double at = m_origin.y() + y * m_scale;
        lines += QLineF(seen.left(), at, seen.right(), at);
    }
    painter.setPen(QPen(QColor(128, 128, 128, 110), 0));
    painter.drawLines(lines);
}

/// A light line on a dark one is seen on every texture; where edges crowd, both get fainter. Without a
/// texture they have the colour of text.
void TextureView::updateEdgeImage()
{
    const QSize pixels = size() * devicePixelRatioF();
    if (m_edgeImage.size() == pixels)
        return;
    m_edgeImage = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    m_edgeImage.setDevicePixelRatio(devicePixelRatioF());
    m_edgeImage.fill(Qt::transparent);
    const QRectF view = QRectF(rect()).adjusted(-2, -2, 2, 2);
    QList<QLineF> lines;
    double length = 0;
    for (const QLineF& edge : std::as_const(m_edges)) {
        const QLineF line(positionOf(edge.p1()), positionOf(edge.p2()));
        length += line.length();
        if (QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1).intersects(view))
            lines += line;
    }
    // So many lines are a blur that some of them make as well, without keeping the interface.
    if (const qsizetype step = 1 + lines.size() / mostLines; step > 1) {
        for (qsizetype kept = 0; kept * step < lines.size(); ++kept)
            lines[kept] = lines[kept * step];
        lines.resize((lines.size() + step - 1) / step);
    }
    const double room = length / static_cast<double>(m_edges.size()) / crowdedEdge;
    const double strength = std::clamp(room, 0.12, 1.0);
    QPainter painter(&m_edgeImage);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isBare = m_picture.image.isNull();
    if (room > 0.4 && !isBare) {
        painter.setPen(QPen(QColor(0, 0, 0, static_cast<int>(150 * strength)), 2.5));
        painter.drawLines(lines);
    }
    QColor line = isBare ? Theme::color(ColorRole::Text) : QColor(Qt::white);
    line.setAlphaF(static_cast<float>(strength));
    painter.setPen(QPen(line, 1));
    painter.drawLines(lines);
}

} // namespace quadrille::widgets
