// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/theme/theme.h"
#include "widgets/tools/smoothline.h"
#include "widgets/tools/surfacecurveeditorprivate.h"
#include "widgets/tools/toolpaint.h"

#include <QPainter>
#include <algorithm>

namespace quadrille::widgets {

namespace {

constexpr double hiddenOpacity = 0.45;

/// Where a curve can be seen, and where the body hides it, as lines on the view.
struct Stretches
{
    std::vector<QPolygonF> seen;
    std::vector<QPolygonF> hidden;
};

/// A sign that something is wrong.
void paintBadge(QPainter& painter, const QPointF& at)
{
    constexpr double radius = 7.0;
    painter.setPen(QPen(Theme::color(ColorRole::Base), 1.5));
    painter.setBrush(Theme::color(ColorRole::Error));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(Theme::textOn(Theme::color(ColorRole::Error)), 1.8, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(at - QPointF(0.0, 3.6), at + QPointF(0.0, 0.8));
    painter.drawPoint(at + QPointF(0.0, 3.6));
}

} // namespace

std::vector<QVector3D> SurfaceCurveEditor::Private::linePlaces(const std::vector<std::uint32_t>& vertices,
                                                               const std::vector<std::size_t>& fixed,
                                                               bool isClosed) const
{
    const auto figureShape = shape();
    if (!figureShape)
        return {};
    std::vector<QVector3D> line;
    line.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices)
        line.push_back(figureShape->place(vertex));
    return withoutZigzag(std::move(line), fixed, isClosed);
}

QPolygonF SurfaceCurveEditor::Private::pieceOf(const std::vector<QVector3D>& line, std::size_t index,
                                               bool isClosed) const
{
    constexpr int pieces = 4;
    QPolygonF pixels;
    for (int piece = 0; piece <= pieces; ++piece) {
        const float share = static_cast<float>(piece) / pieces;
        QPointF pixel;
        if (!owner.camera().project(smoothPlace(line, index, share, isClosed), owner.viewSize(), &pixel))
            return {};
        pixels << pixel;
    }
    return pixels;
}

void SurfaceCurveEditor::Private::paintCurve(QPainter& painter, int index) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(index)];
    const auto& visible = seen()[static_cast<std::size_t>(index)];
    const std::size_t count = curve.vertices.size();
    const std::vector<QVector3D> places = linePlaces(curve.vertices, curve.points, curve.isClosed);
    if (places.empty())
        return;
    const bool isDrawn = mode == Mode::Draw && index == drawn;
    // While it is drawn, the piece that closes it is only what would be.
    const std::size_t last = isDrawn && !curve.points.empty() ? curve.points.back() : count;
    Stretches stretches;
    Stretches closing;
    std::vector<QPolygonF>* current = nullptr;
    for (std::size_t i = 0; i + (curve.isClosed ? 0 : 1) < count; ++i) {
        const std::size_t next = (i + 1) % count;
        const QPolygonF smooth = pieceOf(places, i, curve.isClosed);
        Stretches& piece = i >= last ? closing : stretches;
        auto* wanted = visible[i] && visible[next] ? &piece.seen : &piece.hidden;
        if (smooth.isEmpty()) {
            current = nullptr;
            continue;
        }
        if (wanted != current)
            wanted->push_back({smooth.front()});
        wanted->back() += smooth.mid(1);
        current = wanted;
    }
    const bool isSelected = selected.kind != SurfaceCurvePart::Kind::None && selected.curve == index;
    const bool isHovered = hovered.kind != SurfaceCurvePart::Kind::None && hovered.curve == index;
    const QColor color = !curve.problem.isEmpty() && !isDrawn ? Theme::color(ColorRole::Error) : curve.color;
    const double width = isSelected ? 4.0 : isHovered ? 3.5 : 2.5;
    const auto paintHidden = [&](const std::vector<QPolygonF>& lines) {
        QColor faint = color;
        faint.setAlphaF(static_cast<float>(hiddenOpacity));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(faint, 1.5, Qt::DashLine, Qt::FlatCap, Qt::RoundJoin));
        for (const QPolygonF& line : lines)
            painter.drawPolyline(line);
    };
    paintHidden(stretches.hidden);
    paintHidden(closing.hidden);
    for (const QPolygonF& line : closing.seen)
        paintToolLine(painter, line, color, 1.5, Qt::DotLine);
    for (const QPolygonF& line : stretches.seen)
        paintToolLine(painter, line, color, width, Qt::SolidLine);
}

bool SurfaceCurveEditor::Private::isInHand(int curve) const
{
    const auto isOf = [curve](const SurfaceCurvePart& part) {
        return part.kind != SurfaceCurvePart::Kind::None && part.curve == curve;
    };
    return isOf(selected) || isOf(hovered) || (mode == Mode::Draw && curve == drawn);
}

QRectF SurfaceCurveEditor::Private::boxOf(int index) const
{
    QPolygonF pixels;
    for (const std::uint32_t vertex : curves[static_cast<std::size_t>(index)].vertices)
        if (const auto pixel = project(vertex))
            pixels << *pixel;
    return pixels.boundingRect();
}

void SurfaceCurveEditor::Private::paintPoints(QPainter& painter, int index) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(index)];
    // From afar, points of curves that nobody works on would hide the curves.
    constexpr double roomy = 18.0; // pixels of the box around a curve for each point
    const QRectF box = boxOf(index);
    const bool isSmall =
        !isInHand(index) && box.width() + box.height() < roomy * static_cast<double>(curve.points.size());
    for (int point = 0; point < static_cast<int>(curve.points.size()); ++point) {
        const SurfaceCurvePart part{SurfaceCurvePart::Kind::Point, index, point};
        const auto pixel = owner.pixelOf(part);
        if (!pixel)
            continue;
        HandleLook look{.color = !curve.problem.isEmpty() && index != drawn ? Theme::color(ColorRole::Error)
                                                                            : Theme::color(ColorRole::Text),
                        .isSelected = part == selected,
                        .isHovered = part == hovered};
        if (mode == Mode::Draw && index == drawn && point == 0)
            look.form = HandleLook::Form::Square;
        const bool isSeen = owner.isSeen(part);
        if (isSmall && !isSeen)
            continue;
        if (isSmall || (!isSeen && !look.isSelected))
            look.radius = isSmall ? 1.5 : 3.0;
        painter.setOpacity(isSeen || look.isSelected ? 1.0 : hiddenOpacity);
        paintHandle(painter, *pixel, look);
        painter.setOpacity(1.0);
    }
}

void SurfaceCurveEditor::Private::paintName(QPainter& painter, int index, const QPointF& middle,
                                            std::vector<QRectF>& taken) const
{
    const ShownCurve& curve = curves[static_cast<std::size_t>(index)];
    const auto& visible = seen()[static_cast<std::size_t>(index)];
    const bool isWrong = !curve.problem.isEmpty() && !(mode == Mode::Draw && index == drawn);
    const bool isSelected = selected.kind != SurfaceCurvePart::Kind::None && selected.curve == index;
    const QString text = isWrong && isSelected ? curve.problem : curve.name;
    const QRectF box = boxOf(index);
    constexpr double roomy = 70.0; // pixels
    if (text.isEmpty() || (!isWrong && !isInHand(index) && box.width() + box.height() < roomy))
        return;
    // Outwards from the body, so that the words do not hide it.
    const bool isRight = box.center().x() >= middle.x();
    std::optional<QPointF> edge;
    for (std::size_t i = 0; i < curve.vertices.size(); ++i)
        if (const auto pixel = project(curve.vertices[i]);
            pixel && visible[i] && (!edge || (pixel->x() > edge->x()) == isRight))
            edge = pixel;
    if (!edge)
        return;
    constexpr double away = 24.0;
    const double badge = isWrong ? 20.0 : 0.0;
    const QFontMetricsF metrics(painter.font());
    QRectF plate(0.0, 0.0, metrics.horizontalAdvance(text) + 16.0, metrics.height() + 6.0);
    plate.moveTop(edge->y() - plate.height() / 2.0);
    if (isRight)
        plate.moveLeft(std::min(edge->x() + away + badge, owner.viewSize().width() - plate.width() - 4.0));
    else
        plate.moveRight(std::max(edge->x() - away, plate.width() + badge + 4.0));
    const auto isTaken = [&](const QRectF& other) { return other.intersects(plate); };
    for (int tries = 0; tries < 20 && std::any_of(taken.begin(), taken.end(), isTaken); ++tries)
        plate.translate(0.0, plate.height() / 2.0);
    taken.push_back(plate.adjusted(-badge, 0.0, 0.0, 0.0));
    painter.setPen(QPen(Theme::color(ColorRole::ViewportText), 1.0));
    painter.drawLine(*edge, QPointF(isRight ? plate.left() - badge : plate.right(), plate.center().y()));
    paintToolWords(painter, plate.center(), text);
    if (isWrong)
        paintBadge(painter, QPointF(plate.left() - badge / 2.0, plate.center().y()));
}

void SurfaceCurveEditor::Private::paintDrawing(QPainter& painter) const
{
    const QColor accent = Theme::color(ColorRole::AccentText);
    QPolygonF line;
    const std::vector<QVector3D> places = linePlaces(preview, {}, false);
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        line += pieceOf(places, i, false);
    if (line.size() > 1)
        paintToolLine(painter, line, accent, 2.0, Qt::DashLine);
    QPointF pixel;
    if (pointer && hovered.kind == SurfaceCurvePart::Kind::None &&
        owner.camera().project(pointer->pick.point, owner.viewSize(), &pixel))
        paintHandle(painter, line.isEmpty() ? pixel : line.last(),
                    {.form = cursor ? HandleLook::Form::Diamond : HandleLook::Form::Circle,
                     .radius = 4.0,
                     .color = accent});
}

void SurfaceCurveEditor::Private::paintHint(QPainter& painter) const
{
    const QString text = !refusal.isEmpty() ? refusal : mode == Mode::Draw ? hint() : QString();
    if (text.isEmpty())
        return;
    constexpr double margin = 32.0; // pixels
    const QSizeF& view = owner.viewSize();
    const QRectF plate = paintToolWords(painter, {view.width() / 2.0, view.height() - margin}, text,
                                        std::max(view.width() - 4.0 * margin, margin));
    if (!refusal.isEmpty())
        paintBadge(painter, {plate.left() - 12.0, plate.center().y()});
}

QString SurfaceCurveEditor::Private::hint() const
{
    const ShownCurve* curve = drawnCurve();
    if (curve == nullptr || curve->points.empty())
        return SurfaceCurveEditor::tr("Click on the body for the first point · drag to turn · Esc leaves");
    if (hovered.kind == SurfaceCurvePart::Kind::Point)
        return SurfaceCurveEditor::tr("Click to close the curve");
    return SurfaceCurveEditor::tr("Click for points around the body · Return or a click on the first point "
                                  "closes · Backspace takes one back");
}

void SurfaceCurveEditor::paint(QPainter& painter) const
{
    if (!d->active || !d->shape())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const auto count = static_cast<int>(d->curves.size());
    std::vector<int> order;
    order.reserve(d->curves.size());
    for (int curve = 0; curve < count; ++curve)
        order.push_back(curve);
    std::stable_partition(order.begin(), order.end(), [this](int curve) { return !d->isInHand(curve); });
    QRectF all;
    for (const int curve : order)
        all |= d->boxOf(curve);
    std::vector<QRectF> taken{occupied()};
    for (const int curve : order)
        d->paintCurve(painter, curve);
    for (const int curve : order)
        d->paintName(painter, curve, all.center(), taken);
    for (const int curve : order)
        d->paintPoints(painter, curve);
    if (d->mode == Mode::Draw)
        d->paintDrawing(painter);
    d->paintHint(painter);
}

} // namespace quadrille::widgets
