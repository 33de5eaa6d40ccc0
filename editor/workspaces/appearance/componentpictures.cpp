// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/appearance/componentpictures.h"

#include "editor/pictures/pictures.h"
#include "model/appearance/reducedmodel.h"

#include <QColor>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace quadrille {

namespace {

constexpr double middleGrey = 127.5;
constexpr double mostOfThem = 0.98; ///< of the values, which the colours tell apart
constexpr double halfTurn = 180;    // degrees
constexpr double fullTurn = 360;    // degrees
constexpr int arrowsInThumbnails = 7;

/// The size that nearly all of some values stay below.
float usualSize(std::vector<float> sizes)
{
    if (sizes.empty())
        return 1;
    const auto at =
        sizes.begin() + static_cast<std::ptrdiff_t>(mostOfThem * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), at, sizes.end());
    return std::max(*at, 1e-12F);
}

QRgb* texelOf(QImage& picture, std::uint32_t texel)
{
    const auto width = static_cast<std::uint32_t>(picture.width());
    return reinterpret_cast<QRgb*>(picture.scanLine(static_cast<int>(texel / width))) + texel % width;
}

/// Which way a texel moves: a warp says where it comes from. Bilinear between nodes, as the decoder looks
/// warps up.
Vec2f motionAt(const AppearanceModel& model, int index, int x, int y)
{
    const WarpGrid& grid = model.grid;
    const int i = std::min(x / grid.spacing, std::max(0, grid.width - 2));
    const int j = std::min(y / grid.spacing, std::max(0, grid.height - 2));
    const auto across = static_cast<float>(x - i * grid.spacing) / static_cast<float>(grid.spacing);
    const auto down = static_cast<float>(y - j * grid.spacing) / static_cast<float>(grid.spacing);
    const auto at = [&](int column, int row) {
        const std::int64_t node =
            std::int64_t{std::min(row, grid.height - 1)} * grid.width + std::min(column, grid.width - 1);
        return Vec2f(model.warps.component(index, 2 * node), model.warps.component(index, 2 * node + 1));
    };
    return -((1 - down) * ((1 - across) * at(i, j) + across * at(i + 1, j)) +
             down * ((1 - across) * at(i, j + 1) + across * at(i + 1, j + 1)));
}

/// White with a dark edge, which is seen on any colour.
void drawArrow(QPainter& painter, const QLineF& shaft, double size)
{
    constexpr double spread = 150; // degrees from the shaft to the sides of its head
    constexpr double edge = 0.28;  // widths of pens, in sizes
    constexpr double line = 0.12;
    QLineF side(shaft.p2(), shaft.p2() + QPointF(size, 0));
    side.setLength(0.35 * shaft.length());
    for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 160), edge), {QColor(Qt::white), line}}) {
        painter.setPen(QPen(color, width * size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawLine(shaft);
        for (const double turn : {spread, -spread}) {
            side.setAngle(shaft.angle() + turn);
            painter.drawLine(side);
        }
    }
}

void drawArrows(QImage& picture, const AppearanceModel& model, int index, float longest, int count)
{
    constexpr float least = 0.12F; // shorter ones are dots
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const double apart = static_cast<double>(picture.width()) / count;
    for (double y = apart / 2; y < picture.height(); y += apart) {
        for (double x = apart / 2; x < picture.width(); x += apart) {
            const QPoint texel(static_cast<int>(x), static_cast<int>(y));
            const Vec2f motion = motionAt(model, index, texel.x(), texel.y()) / longest;
            if (motion.norm() < least || qAlpha(picture.pixel(texel)) == 0)
                continue;
            const Vec2f shown = motion * std::min(1.0F, 1 / motion.norm()) * static_cast<float>(apart / 2);
            const QPointF half(static_cast<double>(shown.x()), static_cast<double>(shown.y()));
            drawArrow(painter, {QPointF(x, y) - half, QPointF(x, y) + half}, apart / 2);
        }
    }
}

} // namespace

QImage eigenTexturePicture(const AppearanceModel& model, int index)
{
    const UsedTexels& texels = model.texels;
    std::vector<float> sizes(static_cast<std::size_t>(model.textures.size));
    for (std::size_t value = 0; value < sizes.size(); ++value)
        sizes[value] = std::abs(model.textures.component(index, static_cast<std::int64_t>(value)));
    const float largest = usualSize(std::move(sizes));
    QImage picture(texels.width, texels.height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (std::size_t i = 0; i < texels.texels.size(); ++i) {
        const auto channel = [&](int which) {
            const float value =
                model.textures.component(index, 3 * static_cast<std::int64_t>(i) + which) / largest;
            return static_cast<int>(std::lround(middleGrey * (1 + std::clamp(value, -1.0F, 1.0F))));
        };
        *texelOf(picture, texels.texels[i]) = qRgb(channel(0), channel(1), channel(2));
    }
    return picture;
}

QImage eigenWarpPicture(const AppearanceDecoder& decoder, int index, int arrows)
{
    const AppearanceModel& model = decoder.model();
    const QImage mean = toQImage(decoder.decode({})).convertToFormat(QImage::Format_Grayscale8);
    std::vector<float> lengths;
    for (std::int64_t node = 0; node < model.grid.nodes(); ++node) {
        const Vec2f warp(model.warps.component(index, 2 * node), model.warps.component(index, 2 * node + 1));
        if (warp.squaredNorm() > 0)
            lengths.push_back(warp.norm());
    }
    const float longest = usualSize(std::move(lengths));
    const UsedTexels& texels = model.texels;
    QImage picture(texels.width, texels.height, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (const std::uint32_t texel : texels.texels) {
        const int x = static_cast<int>(texel) % texels.width;
        const int y = static_cast<int>(texel) / texels.width;
        const Vec2f motion = motionAt(model, index, x, y);
        const double strength = std::min(1.0, static_cast<double>(motion.norm() / longest));
        const double angle = std::atan2(motion.y(), motion.x()) * halfTurn / M_PI;
        const QColor hue = QColor::fromHsvF(
            static_cast<float>((angle < 0 ? angle + fullTurn : angle) / fullTurn), 1.0F, 1.0F);
        const int grey = mean.constScanLine(y)[x];
        const auto mixed = [&](int color) {
            return static_cast<int>(std::lround((1 - strength) * grey + strength * color));
        };
        *texelOf(picture, texel) = qRgb(mixed(hue.red()), mixed(hue.green()), mixed(hue.blue()));
    }
    drawArrows(picture, model, index, longest, arrows);
    return picture;
}

std::vector<double> varianceShares(const QuantisedSpace& space)
{
    const double all = std::accumulate(space.eigenvalues.begin(), space.eigenvalues.end(), 0.0);
    std::vector<double> shares;
    for (const double each : space.eigenvalues)
        shares.push_back(all > 0 ? each / all : 0);
    return shares;
}

std::vector<ComponentPicture> componentPictures(const AppearanceModel& model, int side,
                                                const Progress& progress)
{
    int factor = 1;
    while (model.grid.spacing % (2 * factor) == 0 && model.texels.width >= 2 * factor * side)
        factor *= 2;
    const auto small = std::make_shared<const AppearanceModel>(reduced(model, factor, progress.part(0, 0.5)));
    const AppearanceDecoder decoder(small);
    std::vector<ComponentPicture> pictures;
    const std::int64_t count = model.textures.count + model.warps.count;
    const Progress drawing = progress.part(0.5, 1);
    const auto add = [&](const QuantisedSpace& space, bool isWarp) {
        const std::vector<double> shares = varianceShares(space);
        for (int index = 0; index < space.count; ++index) {
            drawing.report(std::ssize(pictures), count);
            const QImage picture = isWarp ? eigenWarpPicture(decoder, index, arrowsInThumbnails)
                                          : eigenTexturePicture(*small, index);
            pictures.push_back({isWarp, index, shares[static_cast<std::size_t>(index)],
                                picture.scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation)});
        }
    };
    add(model.textures, false);
    add(model.warps, true);
    return pictures;
}

} // namespace quadrille
