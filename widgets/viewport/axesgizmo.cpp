// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/viewport/axesgizmo.h"

#include "widgets/theme/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr double radius = 30.0; // from the middle to the ends, pixels
constexpr double endRadius = 8.5;
constexpr double oppositeRadius = 5.5;

ColorRole colorOf(int axis)
{
    constexpr std::array roles{ColorRole::AxisX, ColorRole::AxisY, ColorRole::AxisZ};
    return roles[static_cast<std::size_t>(axis)];
}

} // namespace

AxesGizmo::AxesGizmo(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("axesGizmo"));
    setAttribute(Qt::WA_NoSystemBackground);
    setMouseTracking(true);
    setFocusPolicy(Qt::NoFocus);
    resize(sizeHint());
    connect(&Theme::instance(), &Theme::changed, this, &AxesGizmo::drawAnew);
    retranslate();
}

void AxesGizmo::setCamera(const Turntable& camera)
{
    if (camera.yaw == m_camera.yaw && camera.pitch == m_camera.pitch && camera.upAxis == m_camera.upAxis)
        return;
    m_camera = camera;
    drawAnew();
}

std::array<AxesGizmo::End, 6> AxesGizmo::ends() const
{
    // The sides that the keys look from, told by the camera itself: its front looks along an axis.
    constexpr std::array views{StandardView::Front, StandardView::Back, StandardView::Right,
                               StandardView::Left,  StandardView::Top,  StandardView::Bottom};
    std::array<End, 6> ends;
    for (std::size_t i = 0; i < views.size(); ++i) {
        Turntable from = m_camera;
        from.look(views[i]);
        const QVector3D outward = -from.forward();
        End& end = ends[i];
        end.view = views[i];
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(outward[axis]) > 0.5F) {
                end.axis = axis;
                end.isPositive = outward[axis] > 0.0F;
            }
        }
        const QPointF middle = QRectF(rect()).center();
        end.place =
            middle + radius * QPointF(static_cast<double>(QVector3D::dotProduct(outward, m_camera.right())),
                                      -static_cast<double>(QVector3D::dotProduct(outward, m_camera.up())));
        end.nearness = -QVector3D::dotProduct(outward, m_camera.forward());
    }
    std::ranges::stable_sort(ends, {}, &End::nearness);
    return ends;
}

std::optional<QPointF> AxesGizmo::endOf(StandardView view) const
{
    for (const End& end : ends()) {
        if (end.view == view)
            return viewAt(end.place) == view ? std::optional(end.place) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<StandardView> AxesGizmo::viewAt(const QPointF& position) const
{
    const auto sorted = ends();
    const auto found = std::find_if(sorted.rbegin(), sorted.rend(), [&position](const End& end) {
        const QPointF apart = position - end.place;
        return QPointF::dotProduct(apart, apart) <= (endRadius + 1.0) * (endRadius + 1.0);
    });
    return found == sorted.rend() ? std::nullopt : std::optional(found->view);
}

void AxesGizmo::drawAnew()
{
    m_picture = QPixmap();
    update();
}

/// It lies over the viewport, and so is painted with each picture of that.
void AxesGizmo::paintEvent(QPaintEvent* /*event*/)
{
    const double ratio = devicePixelRatioF();
    if (m_picture.isNull() || m_picture.devicePixelRatio() != ratio) {
        m_picture = QPixmap(size() * ratio);
        m_picture.setDevicePixelRatio(ratio);
        m_picture.fill(Qt::transparent);
        draw();
    }
    QPainter(this).drawPixmap(0, 0, m_picture);
}

void AxesGizmo::draw()
{
    QPainter painter(&m_picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    QFont font = this->font();
    font.setBold(true);
    font.setPixelSize(11);
    painter.setFont(font);
    static const std::array letters{QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")};
    for (const End& end : ends()) {
        // What points away is fainter, but can be read.
        QColor color = Theme::color(colorOf(end.axis));
        color.setAlphaF(std::clamp(0.8F + 0.2F * end.nearness, 0.6F, 1.0F));
        const bool isHovered = m_hovered == end.view;
        if (end.isPositive) {
            painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(middle, end.place);
            painter.setPen(isHovered ? QPen(Theme::color(ColorRole::Text), 2.0) : QPen(Qt::NoPen));
            painter.setBrush(color);
            painter.drawEllipse(end.place, endRadius, endRadius);
            painter.setPen(Theme::textOn(color));
            painter.drawText(
                QRectF(end.place - QPointF(endRadius, endRadius), QSizeF(2 * endRadius, 2 * endRadius)),
                Qt::AlignCenter, letters[static_cast<std::size_t>(end.axis)]);
        } else {
            QColor fill = Theme::color(ColorRole::ViewportBottom);
            fill.setAlphaF(0.85F);
            painter.setPen(QPen(isHovered ? Theme::color(ColorRole::Text) : color, 2.0));
            painter.setBrush(fill);
            painter.drawEllipse(end.place, oppositeRadius, oppositeRadius);
        }
    }
}

void AxesGizmo::mousePressEvent(QMouseEvent* event)
{
    const auto view = viewAt(event->position());
    if (event->button() != Qt::LeftButton || !view) {
        event->ignore();
        return;
    }
    emit lookRequested(*view);
}

void AxesGizmo::mouseMoveEvent(QMouseEvent* event)
{
    const auto view = viewAt(event->position());
    if (view == m_hovered)
        return;
    m_hovered = view;
    setCursor(view ? Qt::PointingHandCursor : Qt::ArrowCursor);
    drawAnew();
}

void AxesGizmo::leaveEvent(QEvent* event)
{
    m_hovered.reset();
    drawAnew();
    QWidget::leaveEvent(event);
}

void AxesGizmo::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::FontChange)
        drawAnew();
    QWidget::changeEvent(event);
}

void AxesGizmo::retranslate()
{
    setAccessibleName(tr("Axes"));
    setToolTip(tr("Click an axis to look from its end (keys 1, 3, 7)"));
}

} // namespace quadrille::widgets

#include "moc_axesgizmo.cpp"
