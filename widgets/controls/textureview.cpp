// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/controls/textureview.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double largestZoom = 64;        // screen pixels for each of the texture
constexpr double smallestSide = 32;       // logical pixels that the texture keeps when zoomed out
constexpr double keyZoom = 1.25;          // for one press of + or −
constexpr double wheelZoom = 1.2;         // for one notch of the wheel
constexpr double notch = 120;             // eighths of a degree
constexpr double keyStep = 48;            // logical pixels for one press of an arrow
constexpr double margin = 8;              // logical pixels around a texture that is fitted
constexpr double sideWithoutImage = 1024; // pixels that the unit square stands for without a picture

} // namespace

TextureView::TextureView(QWidget* parent)
    : QWidget(parent)
    , m_empty(new QWidget(this))
    , m_emptyText(new QLabel)
    , m_emptyColumn(new QVBoxLayout(m_empty))
{
    setObjectName(QStringLiteral("textureView"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_emptyText->setObjectName(QStringLiteral("textureViewEmpty"));
    m_emptyText->setWordWrap(true);
    m_emptyText->setForegroundRole(QPalette::PlaceholderText);
    m_emptyText->setAlignment(Qt::AlignCenter);
    m_emptyColumn->setContentsMargins(16, 16, 16, 16);
    m_emptyColumn->setSpacing(12);
    m_emptyColumn->addStretch(1);
    m_emptyColumn->addWidget(m_emptyText);
    m_emptyColumn->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_empty);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        m_edgeImage = {};
        update();
    });
}

void TextureView::setPicture(TexturePicture picture)
{
    const QSizeF before = textureSize();
    if (picture.image.isNull() != m_picture.image.isNull())
        m_edgeImage = {};
    m_picture = std::move(picture);
    if (textureSize() != before)
        m_isFitted = true;
    contentChanged();
}

void TextureView::setUvEdges(QList<QLineF> edges)
{
    m_edges = std::move(edges);
    m_edgeImage = {};
    contentChanged();
}

void TextureView::setEmptyText(const QString& text)
{
    m_emptyText->setText(text);
}

void TextureView::setEmptyAction(QWidget* action)
{
    m_emptyColumn->insertWidget(2, action, 0, Qt::AlignHCenter);
}

void TextureView::contentChanged()
{
    m_empty->setVisible(isEmpty());
    setFocusPolicy(isEmpty() ? Qt::NoFocus : Qt::StrongFocus);
    if (m_isFitted)
        fit();
    if (isEmpty() && std::exchange(m_isHovered, false))
        emit hoverEnded();
    update();
}

QSizeF TextureView::textureSize() const
{
    return m_picture.image.isNull() ? QSizeF(sideWithoutImage, sideWithoutImage)
                                    : QSizeF(m_picture.image.size());
}

QRectF TextureView::textureRect() const
{
    return {m_origin, textureSize() * m_scale};
}

double TextureView::zoom() const
{
    return m_scale * devicePixelRatioF();
}

double TextureView::fittingScale() const
{
    const QSizeF size = textureSize();
    return std::min(std::max(smallestSide, width() - 2 * margin) / size.width(),
                    std::max(smallestSide, height() - 2 * margin) / size.height());
}

void TextureView::setScale(double scale, const QPointF& origin)
{
    const double scaleBefore = std::exchange(m_scale, scale);
    const QPointF originBefore = std::exchange(m_origin, origin);
    keepInView();
    if (m_scale == scaleBefore && m_origin == originBefore)
        return;
    viewChanged();
    emit zoomChanged(zoom());
    emit viewMoved();
}

void TextureView::zoomAbout(const QPointF& position, double factor)
{
    const double largest = std::max(largestZoom / devicePixelRatioF(), fittingScale());
    const QSizeF size = textureSize();
    const double smallest = std::min(smallestSide / std::max(size.width(), size.height()), fittingScale());
    const double scale = std::clamp(m_scale * factor, smallest, largest);
    m_isFitted = false;
    setScale(scale, position - (position - m_origin) * (scale / m_scale));
}

void TextureView::fit()
{
    m_isFitted = true;
    const double scale = fittingScale();
    const QSizeF rest = (QSizeF(size()) - textureSize() * scale) / 2;
    setScale(scale, {rest.width(), rest.height()});
}

void TextureView::showActualSize()
{
    zoomAbout(QRectF(rect()).center(), 1 / zoom());
}

void TextureView::moveBy(const QPointF& distance)
{
    m_isFitted = false;
    m_origin += distance;
    keepInView();
    viewChanged();
    emit viewMoved();
}

void TextureView::showLike(const TextureView& other)
{
    const QSignalBlocker quiet(this);
    m_isFitted = other.m_isFitted;
    if (m_isFitted)
        fit();
    else
        setScale(other.m_scale, other.m_origin);
}

/// Some of the texture always covers the middle of the view.
void TextureView::keepInView()
{
    const QSizeF size = textureSize() * m_scale;
    const QPointF middle = QRectF(rect()).center();
    m_origin.setX(std::clamp(m_origin.x(), middle.x() - size.width(), middle.x()));
    m_origin.setY(std::clamp(m_origin.y(), middle.y() - size.height(), middle.y()));
}

void TextureView::viewChanged()
{
    m_edgeImage = {};
    if (m_isHovered)
        reportHover(m_pointer);
    update();
}

QPointF TextureView::positionOf(const QPointF& uv) const
{
    const QRectF place = textureRect();
    return {place.left() + uv.x() * place.width(), place.bottom() - uv.y() * place.height()};
}

QPointF TextureView::uvAt(const QPointF& position) const
{
    const QRectF place = textureRect();
    return {(position.x() - place.left()) / place.width(), (place.bottom() - position.y()) / place.height()};
}

QPoint TextureView::pixelAt(const QPointF& position) const
{
    const QPointF pixel = (position - m_origin) / m_scale;
    return {static_cast<int>(std::floor(pixel.x())), static_cast<int>(std::floor(pixel.y()))};
}

void TextureView::reportHover(const QPointF& position)
{
    const bool isOver = !isEmpty() && textureRect().contains(position);
    if (isOver)
        emit hovered(uvAt(position), pixelAt(position));
    else if (m_isHovered)
        emit hoverEnded();
    m_isHovered = isOver;
}

void TextureView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (m_isFitted) {
        fit();
    } else {
        keepInView();
        viewChanged();
    }
}

void TextureView::wheelEvent(QWheelEvent* event)
{
    if (isEmpty()) {
        event->ignore();
        return;
    }
    m_pointer = event->position();
    zoomAbout(m_pointer, std::pow(wheelZoom, event->angleDelta().y() / notch));
    event->accept();
}

void TextureView::mousePressEvent(QMouseEvent* event)
{
    const bool moves = event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton;
    if (isEmpty() || !moves) {
        event->ignore();
        return;
    }
    m_isDragging = true;
    m_pointer = event->position();
    setCursor(Qt::ClosedHandCursor);
}

void TextureView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = std::exchange(m_pointer, event->position());
    if (m_isDragging)
        moveBy(m_pointer - before);
    reportHover(m_pointer);
}

void TextureView::mouseReleaseEvent(QMouseEvent* event)
{
    m_isDragging = m_isDragging && (event->buttons() & (Qt::LeftButton | Qt::MiddleButton)) != 0;
    if (!m_isDragging)
        unsetCursor();
}

void TextureView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !isEmpty())
        fit();
}

void TextureView::leaveEvent(QEvent* /*event*/)
{
    if (std::exchange(m_isHovered, false))
        emit hoverEnded();
}

/// Whether an arrow brings anything into view that is hidden now.
bool TextureView::mayMove(int key) const
{
    const QRectF place = textureRect();
    switch (key) {
    case Qt::Key_Left:
        return place.left() < 0;
    case Qt::Key_Right:
        return place.right() > width();
    case Qt::Key_Up:
        return place.top() < 0;
    case Qt::Key_Down:
        return place.bottom() > height();
    default:
        return false;
    }
}

bool TextureView::event(QEvent* event)
{
    // These keys mean something else in the window: here they are for the texture.
    if (event->type() == QEvent::ShortcutOverride && !isEmpty()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == 0;
        const bool isOurs = key->key() == Qt::Key_F || key->key() == Qt::Key_0 ||
                            key->key() == Qt::Key_Plus || key->key() == Qt::Key_Equal ||
                            key->key() == Qt::Key_Minus || mayMove(key->key());
        if (isPlain && isOurs) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void TextureView::keyPressEvent(QKeyEvent* event)
{
    if (isEmpty()) {
        QWidget::keyPressEvent(event);
        return;
    }
    const QPointF middle = QRectF(rect()).center();
    const int key = event->key();
    if (key == Qt::Key_Plus || key == Qt::Key_Equal)
        zoomAbout(middle, keyZoom);
    else if (key == Qt::Key_Minus)
        zoomAbout(middle, 1 / keyZoom);
    else if (key == Qt::Key_0)
        showActualSize();
    else if (key == Qt::Key_F)
        fit();
    else if (!mayMove(key))
        QWidget::keyPressEvent(event);
    else if (key == Qt::Key_Left || key == Qt::Key_Right)
        moveBy({key == Qt::Key_Left ? keyStep : -keyStep, 0});
    else
        moveBy({0, key == Qt::Key_Up ? keyStep : -keyStep});
}

} // namespace quadrille::widgets

#include "moc_textureview.cpp"
