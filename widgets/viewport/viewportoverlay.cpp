// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/viewportoverlay.h"

#include "widgets/controls/legendbar.h"
#include "widgets/theme/plate.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/labelplaces.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>

namespace quadrille::widgets {

namespace {

void paintCentred(QPainter& painter, const QPointF& center, const QString& text, const QColor& mark)
{
    QRectF place(QPointF(), labelSize(painter, text, mark));
    place.moveCenter(center);
    paintLabel(painter, place, text, mark);
}

/// \return the lower end.
double paintListed(QPainter& painter, double top, const Annotations::Name& name)
{
    constexpr double left = 12.0;
    const QSizeF size = labelSize(painter, name.text, name.color);
    paintLabel(painter, QRectF(QPointF(left, top), size), name.text, name.color);
    return top + size.height();
}

/// Above their figures, and above each other where they would overlap.
void paintNames(QPainter& painter, const QSizeF& size, const Annotations& annotations)
{
    std::vector<QRectF> placed;
    for (const Annotations::Name& name : annotations.names) {
        QPointF pixel;
        if (!annotations.camera.project(name.place, size, &pixel))
            continue;
        QRectF plate(QPointF(), labelSize(painter, name.text, name.color));
        plate.moveCenter(pixel - QPointF(0.0, 16.0));
        const auto isInTheWay = [&plate](const QRectF& other) { return plate.intersects(other); };
        auto other = std::ranges::find_if(placed, isInTheWay);
        for (; other != placed.end(); other = std::ranges::find_if(placed, isInTheWay))
            plate.moveBottom(other->top() - 2.0);
        placed.push_back(plate);
        paintLabel(painter, plate, name.text, name.color);
    }
}

/// What a box covers of the view, pixels; empty when a part of it is behind the camera.
QRectF outlineOf(const std::pair<QVector3D, QVector3D>& box, const Turntable& camera, const QSizeF& size)
{
    QPolygonF corners;
    for (int corner = 0; corner < 8; ++corner) {
        QVector3D place;
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = ((corner >> axis) & 1) == 0 ? box.first[axis] : box.second[axis];
        QPointF pixel;
        if (!camera.project(place, size, &pixel))
            return {};
        corners += pixel;
    }
    return corners.boundingRect();
}

/// Beside their places, clear of handles, of each other and, where they are meant to, of figures.
void paintLabels(QPainter& painter, const QSizeF& size, const Annotations& annotations)
{
    constexpr double handleRadius = 8.0; // with the halo
    std::vector<QRectF> handles;
    QPointF pixel;
    for (const QVector3D& handle : annotations.handles)
        if (annotations.camera.project(handle, size, &pixel))
            handles.emplace_back(pixel.x() - handleRadius, pixel.y() - handleRadius, 2.0 * handleRadius,
                                 2.0 * handleRadius);
    std::vector<QRectF> figures;
    for (const auto& box : annotations.figures)
        figures.push_back(outlineOf(box, annotations.camera, size));
    std::vector<PlateRequest> plates;
    std::vector<const SceneLabel*> seen;
    for (const SceneLabel& label : annotations.labels) {
        if (!annotations.camera.project(label.place, size, &pixel))
            continue;
        plates.push_back({pixel, labelSize(painter, label.text, label.color),
                          label.beside ? figures : std::vector<QRectF>()});
        seen.push_back(&label);
    }
    const std::vector<QRectF> places = placePlates(plates, std::move(handles), QRectF(QPointF(), size));
    for (std::size_t i = 0; i < places.size(); ++i)
        paintCentred(painter, places[i].center(), seen[i]->text, seen[i]->color);
}

void paintMeasurement(QPainter& painter, const QSizeF& size, const Annotations& annotations)
{
    std::vector<QPointF> pixels;
    for (const QVector3D& point : annotations.measured) {
        QPointF pixel;
        if (!annotations.camera.project(point, size, &pixel))
            return;
        pixels.push_back(pixel);
    }
    const QColor halo = Theme::color(ColorRole::Base);
    const QColor accent = Theme::color(ColorRole::Accent);
    if (pixels.size() == 2) {
        painter.setPen(QPen(halo, 4.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(pixels[0], pixels[1]);
        painter.setPen(QPen(accent, 2.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(pixels[0], pixels[1]);
    }
    painter.setPen(QPen(halo, 1.5));
    painter.setBrush(accent);
    for (const QPointF& pixel : pixels)
        painter.drawEllipse(pixel, 4.5, 4.5);
    if (pixels.size() == 2) {
        const auto length = static_cast<double>((annotations.measured[1] - annotations.measured[0]).length());
        paintCentred(painter, (pixels[0] + pixels[1]) / 2.0 - QPointF(0.0, 18.0),
                     annotations.ruler.text(length), {});
    }
}

void paintNotice(QPainter& painter, const QSizeF& size, const QString& text, Qt::Alignment place)
{
    if (text.isEmpty())
        return;
    constexpr double margin = 24.0;
    const QRectF inside = QRectF(QPointF(), size).adjusted(margin, margin, -margin, -margin);
    const int flags = static_cast<int>(place | Qt::AlignHCenter) | Qt::TextWordWrap;
    QRectF plate = painter.boundingRect(inside, flags, text);
    plate.adjust(-16.0, -10.0, 16.0, 10.0);
    paintPlate(painter, plate, 6.0);
    painter.setPen(Theme::color(ColorRole::Text));
    painter.drawText(inside, flags, text);
}

constexpr double keyPadding = 8.0;
constexpr double keySide = 12.0; // of a field of colour

double keyRow(const QFontMetricsF& metrics)
{
    return metrics.height() + 4.0;
}

/// With the plate around it.
QRectF keyPlace(const QFont& font, const QSizeF& size, const ColorKey& key)
{
    constexpr double margin = 8.0;
    const QFontMetricsF metrics(font);
    double width = metrics.horizontalAdvance(key.title);
    for (const ColorKey::Item& item : key.items)
        width = std::max(width, metrics.horizontalAdvance(item.name) + keySide + 8.0);
    const QSizeF plate(width + 2.0 * keyPadding,
                       keyRow(metrics) * static_cast<double>(key.items.size() + 1) + 2.0 * keyPadding);
    return {QPointF(size.width() - plate.width() - margin, margin), plate};
}

/// Names beside their colours, at the upper right.
void paintKey(QPainter& painter, const QSizeF& size, const ColorKey& key)
{
    constexpr double side = keySide;
    const double row = keyRow(QFontMetricsF(painter.font()));
    const QRectF plate = keyPlace(painter.font(), size, key);
    paintPlate(painter, plate, 6.0);
    QRectF line(plate.topLeft() + QPointF(keyPadding, keyPadding),
                QSizeF(plate.width() - 2.0 * keyPadding, row));
    painter.setPen(Theme::color(ColorRole::TextMuted));
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, key.title);
    for (const ColorKey::Item& item : key.items) {
        line.translate(0.0, row);
        painter.setPen(QPen(Theme::color(ColorRole::Line), 1.0));
        painter.setBrush(item.color);
        painter.drawRect(QRectF(line.left(), line.center().y() - side / 2.0, side, side));
        painter.setPen(Theme::color(ColorRole::Text));
        painter.drawText(line.adjusted(side + 8.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                         item.name);
    }
}

/// All but the notice.
void paintWords(QPainter& painter, const QSizeF& size, const Annotations& annotations)
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (annotations.namesListed) {
        double row = 12.0;
        for (const Annotations::Name& name : annotations.names)
            row = paintListed(painter, row, name) + 4.0;
    } else {
        paintNames(painter, size, annotations);
    }
    paintLabels(painter, size, annotations);
    paintMeasurement(painter, size, annotations);
    if (annotations.key)
        paintKey(painter, size, *annotations.key);
    if (annotations.legend) {
        constexpr double margin = 16.0;
        const QSizeF legend = legendSize(painter.font(), *annotations.legend);
        const QRectF place(QPointF(size.width() - legend.width() - margin, margin), legend);
        QColor background = Theme::color(ColorRole::Base);
        background.setAlphaF(0.78F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(background);
        painter.drawRoundedRect(place.adjusted(-8.0, -8.0, 8.0, 8.0), 6.0, 6.0);
        paintLegend(painter, place, *annotations.legend, Theme::color(ColorRole::Text));
    }
}

} // namespace

void paintAnnotations(QPainter& painter, const QSizeF& size, const Annotations& annotations)
{
    paintWords(painter, size, annotations);
    paintNotice(painter, size, annotations.notice, Qt::AlignVCenter);
}

ViewportOverlay::ViewportOverlay(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setObjectName(QStringLiteral("viewportOverlay"));
    hide();
}

void ViewportOverlay::show(const Annotations& annotations)
{
    const bool changed = !(annotations == m_annotations);
    m_annotations = annotations;
    setVisible(m_tool || !annotations.isEmpty());
    if (changed && isVisible())
        update();
}

void ViewportOverlay::setTool(ViewTool* tool)
{
    m_tool = tool;
    setVisible(m_tool || !m_annotations.isEmpty());
    update();
}

void ViewportOverlay::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    if (!m_tool) {
        paintAnnotations(painter, size(), m_annotations);
        return;
    }
    paintWords(painter, size(), m_annotations);
    m_tool->setOccupied(m_annotations.key ? keyPlace(painter.font(), size(), *m_annotations.key) : QRectF());
    m_tool->paint(painter);
    // What a tool draws fills the middle.
    paintNotice(painter, size(), m_annotations.notice, Qt::AlignBottom);
}

} // namespace quadrille::widgets

#include "moc_viewportoverlay.cpp"
