// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/weightspad.h"

#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace quadrille::widgets {

namespace {

constexpr int side = 132;     // pixels, of the square as it likes to be
constexpr int leastSide = 80; // pixels
constexpr double radius = 6;  // pixels, of the point
constexpr double reach = 6;   // pixels about a node that the point clings in
constexpr double nameGap = 4; // pixels between the square and the names
constexpr double step = 0.01; // of an arrow
constexpr double leap = 0.1;  // of an arrow with Shift
constexpr double percent = 100;

QPointF limited(const QPointF& weights)
{
    return {std::clamp(weights.x(), 0.0, 1.0), std::clamp(weights.y(), 0.0, 1.0)};
}

/// Free of what repeated steps leave behind the last digit.
QPointF inHundredths(const QPointF& weights)
{
    return {std::round(weights.x() * percent) / percent, std::round(weights.y() * percent) / percent};
}

/// Where a key leads to from some weights.
std::optional<QPointF> stepped(const QPointF& from, const QKeyEvent& event)
{
    if ((event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0)
        return std::nullopt;
    const double by = (event.modifiers() & Qt::ShiftModifier) != 0 ? leap : step;
    switch (event.key()) {
    case Qt::Key_Left:
        return from - QPointF(by, 0);
    case Qt::Key_Right:
        return from + QPointF(by, 0);
    case Qt::Key_Down:
        return from - QPointF(0, by);
    case Qt::Key_Up:
        return from + QPointF(0, by);
    case Qt::Key_Home:
        return QPointF(0, from.y());
    case Qt::Key_End:
        return QPointF(1, from.y());
    case Qt::Key_PageDown:
        return QPointF(from.x(), 0);
    case Qt::Key_PageUp:
        return QPointF(from.x(), 1);
    default:
        return std::nullopt;
    }
}

} // namespace

WeightsPad::WeightsPad(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("weightsPad"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
    tellValue();
}

void WeightsPad::setCorners(const std::array<QString, 4>& names)
{
    m_corners = names;
    tellValue();
    update();
}

void WeightsPad::setNodes(std::vector<QPointF> nodes)
{
    m_nodes = std::move(nodes);
    update();
}

void WeightsPad::setWeights(const QPointF& weights)
{
    if (isDragged())
        return;
    m_weights = limited(weights);
    tellValue();
    update();
}

QRectF WeightsPad::square() const
{
    const double line = fontMetrics().height();
    const double height = this->height() - 2 * (line + nameGap);
    const double size = std::max(1.0, std::min<double>(height, width() - 2 * radius) - 2);
    return {(width() - size) / 2, line + nameGap + (height - size) / 2, size, size};
}

QPointF WeightsPad::positionOf(const QPointF& weights) const
{
    const QRectF place = square();
    return {place.left() + weights.x() * place.width(), place.bottom() - weights.y() * place.height()};
}

QPointF WeightsPad::weightsAt(const QPointF& position) const
{
    for (const QPointF& node : m_nodes) {
        const QPointF away = positionOf(node) - position;
        if (std::hypot(away.x(), away.y()) <= reach)
            return node;
    }
    const QRectF place = square();
    return inHundredths(limited(
        {(position.x() - place.left()) / place.width(), (place.bottom() - position.y()) / place.height()}));
}

QSize WeightsPad::sizeHint() const
{
    return {side, side + 2 * (fontMetrics().height() + static_cast<int>(nameGap))};
}

QSize WeightsPad::minimumSizeHint() const
{
    return {leastSide, leastSide + 2 * (fontMetrics().height() + static_cast<int>(nameGap))};
}

void WeightsPad::move(const QPointF& weights, bool isFinal)
{
    m_weights = limited(weights);
    tellValue();
    update();
    emit edited(m_weights, isFinal);
}

void WeightsPad::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_before = m_weights;
    move(weightsAt(event->position()), false);
}

void WeightsPad::mouseMoveEvent(QMouseEvent* event)
{
    if (isDragged())
        move(weightsAt(event->position()), false);
}

void WeightsPad::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !isDragged())
        return;
    const QPointF weights = weightsAt(event->position());
    m_before.reset();
    move(weights, true);
}

void WeightsPad::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && isDragged()) {
        const QPointF before = *m_before;
        m_before.reset();
        move(before, true);
        return;
    }
    const auto to = stepped(m_weights, *event);
    if (!to || isDragged()) {
        QWidget::keyPressEvent(event);
        return;
    }
    const QPointF weights = inHundredths(limited(*to));
    if (weights != m_weights)
        move(weights, true);
}

bool WeightsPad::event(QEvent* event)
{
    // Shortcuts of the window on the same keys wait while the pad has the focus.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (stepped(m_weights, *key) || (key->key() == Qt::Key_Escape && isDragged())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void WeightsPad::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange)
        tellValue();
    if (event->type() == QEvent::FontChange)
        updateGeometry();
    QWidget::changeEvent(event);
}

/// What assistive tools read out.
void WeightsPad::tellValue()
{
    const auto share = [this](double value) { return locale().toString(value * percent, 'f', 0); };
    //: shares of two weights, to the right and upwards, in percent
    setAccessibleDescription(
        tr("%1 % to the right, %2 % upwards").arg(share(m_weights.x()), share(m_weights.y())));
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
}

void WeightsPad::paintNames(QPainter& painter) const
{
    const QRectF place = square();
    const double line = fontMetrics().height();
    const double half = width() / 2.0 - nameGap;
    painter.setPen(Theme::color(isEnabled() ? ColorRole::TextMuted : ColorRole::TextDisabled));
    for (std::size_t c = 0; c < m_corners.size(); ++c) {
        const bool isRight = (c & 1U) != 0;
        const bool isTop = (c & 2U) != 0;
        const QRectF rect(isRight ? width() - half : 0,
                          isTop ? place.top() - nameGap - line : place.bottom() + nameGap, half, line);
        painter.drawText(rect, (isRight ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter,
                         fontMetrics().elidedText(m_corners[c], Qt::ElideMiddle, static_cast<int>(half)));
    }
}

void WeightsPad::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF place = square();
    painter.setPen(QPen(Theme::color(hasFocus() ? ColorRole::Accent : ColorRole::Line), hasFocus() ? 2 : 1));
    painter.setBrush(Theme::color(ColorRole::Base));
    painter.drawRect(place);
    const QPointF at = positionOf(m_weights);
    painter.setPen(QPen(Theme::color(ColorRole::Divider), 1));
    painter.drawLine(QPointF(place.left(), at.y()), QPointF(place.right(), at.y()));
    painter.drawLine(QPointF(at.x(), place.top()), QPointF(at.x(), place.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(Theme::color(ColorRole::TextMuted));
    for (const QPointF& node : m_nodes)
        painter.drawEllipse(positionOf(node), radius / 3, radius / 3);
    painter.setPen(QPen(Theme::color(ColorRole::Base), 2));
    painter.setBrush(Theme::color(isEnabled() ? ColorRole::Accent : ColorRole::TextDisabled));
    painter.drawEllipse(at, radius, radius);
    paintNames(painter);
}

} // namespace quadrille::widgets

#include "moc_weightspad.cpp"
