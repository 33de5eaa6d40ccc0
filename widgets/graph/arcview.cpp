// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/arcview.h"

#include "widgets/graph/chartscale.h"
#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double bundlePixels = 3; // arcs whose ends are nearer than that look the same
constexpr int mostBundles = 300;   // on each side
constexpr double arcReach = 6;     // pixels about an arc that take hold of it
constexpr double arcMargin = 8;

} // namespace

ArcView::ArcView(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("arcView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        m_picture = {};
        update();
    });
}

void ArcView::setSequences(std::vector<ArcSequence> sequences)
{
    m_sequences = std::move(sequences);
    m_starts = {0};
    for (const ArcSequence& sequence : m_sequences)
        m_starts.push_back(m_starts.back() + sequence.frames);
    m_scale.setFrameCount(m_starts.back());
    m_halves = {};
    setCurrent({});
    viewChanged();
}

void ArcView::setArcs(Side side, const QString& title, std::shared_ptr<const std::vector<Arc>> arcs)
{
    m_halves[static_cast<std::size_t>(side)] = {title, std::move(arcs), {}};
    viewChanged();
    const auto& bundles = shown(side);
    if (m_current && m_current->side == side &&
        std::none_of(bundles.begin(), bundles.end(),
                     [this](const ArcBundle& bundle) { return bundle.lightest == m_current->arc; }))
        setCurrent({});
}

void ArcView::setEmptyText(const QString& text)
{
    m_emptyText = text;
    update();
}

QString ArcView::arcText(const Arc& arc) const
{
    const auto frame = [this](int index) {
        const auto sequence = static_cast<std::size_t>(sequenceOf(index));
        //: a sequence and one of its frames
        return tr("%1 %2").arg(m_sequences[sequence].name, QString::number(index - m_starts[sequence]));
    };
    //: two frames and the weight of the edge between them
    return tr("%1 → %2: %3").arg(frame(arc.from), frame(arc.to), chartNumber(arc.weight));
}

std::optional<ArcView::Place> ArcView::currentArc() const
{
    return m_current;
}

const std::vector<ArcBundle>& ArcView::shown(Side side) const
{
    return half(side).shown;
}

int ArcView::sequenceOf(int frame) const
{
    return static_cast<int>(std::upper_bound(m_starts.begin(), m_starts.end(), frame) - m_starts.begin()) - 1;
}

double ArcView::barHeight() const
{
    return std::ceil(QFontMetricsF(font()).height()) + 6;
}

double ArcView::barTop() const
{
    return std::floor((height() - barHeight()) / 2);
}

double ArcView::xOf(double frame) const
{
    return arcMargin + m_scale.xOf(frame);
}

ArcCurve ArcView::curve(Side side, const Arc& arc) const
{
    const bool isAbove = side == Side::Above;
    const double line = QFontMetricsF(font()).height() + arcMargin; // title
    const double room = std::max(barTop() - line, 8.0);
    const double from = xOf(arc.from + 0.5);
    const double to = xOf(arc.to + 0.5);
    const double height = std::max(room * std::sqrt(std::min(std::abs(to - from) / width(), 1.0)), 4.0);
    return {from, to, isAbove ? barTop() : barTop() + barHeight(), isAbove ? height : -height};
}

QRectF ArcView::sequenceRect(int sequence) const
{
    const auto at = static_cast<std::size_t>(sequence);
    return {xOf(m_starts[at]), barTop(), xOf(m_starts[at + 1]) - xOf(m_starts[at]), barHeight()};
}

std::optional<ArcView::Place> ArcView::arcAt(const QPointF& position) const
{
    if (isEmpty())
        return {};
    const double middle = barTop() + barHeight() / 2;
    const Side side = position.y() < middle ? Side::Above : Side::Below;
    std::optional<Place> nearest;
    double least = arcReach;
    for (const ArcBundle& bundle : shown(side)) {
        const double distance = curve(side, bundle.lightest).distance(position);
        if (distance < least) {
            least = distance;
            nearest = Place{side, bundle.lightest};
        }
    }
    return nearest;
}

void ArcView::viewChanged()
{
    m_scale.setWidth(width() - 2 * arcMargin);
    const int each = std::max(static_cast<int>(std::lround(bundlePixels / m_scale.pixelsPerFrame())), 1);
    for (Half& half : m_halves)
        half.shown =
            half.arcs ? bundleArcs(*half.arcs, m_starts, each, mostBundles) : std::vector<ArcBundle>();
    m_picture = {};
    update();
}

void ArcView::zoomBy(double factor)
{
    m_scale.zoom(factor, m_scale.width() / 2);
    viewChanged();
}

void ArcView::setCurrent(const std::optional<Place>& place)
{
    if (place == m_current)
        return;
    m_current = place;
    setAccessibleDescription(place ? arcText(place->arc) : QString());
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    update();
    if (place)
        emit arcHovered(place->arc.from, place->arc.to);
    else
        emit hoverEnded();
}

bool ArcView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && !isEmpty()) {
        // These keys mean something else in the window: here they are for the arcs.
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == 0;
        switch (key->key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Plus:
        case Qt::Key_Equal:
        case Qt::Key_Minus:
        case Qt::Key_0:
            event->setAccepted(isPlain);
            return true;
        default:
            break;
        }
    }
    return QWidget::event(event);
}

void ArcView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    viewChanged();
}

void ArcView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    viewChanged();
}

void ArcView::wheelEvent(QWheelEvent* event)
{
    m_scale.zoom(std::pow(chartWheelZoom, event->angleDelta().y() / wheelNotch),
                 event->position().x() - arcMargin);
    viewChanged();
    event->accept();
}

void ArcView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_isPressed = true;
    m_isDragging = false;
    m_pressedAt = m_pointer = event->position();
}

void ArcView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = std::exchange(m_pointer, event->position());
    if (m_isPressed &&
        (m_isDragging || (m_pointer - m_pressedAt).manhattanLength() >= QApplication::startDragDistance())) {
        m_isDragging = true;
        const double distance = m_pointer.x() - before.x();
        m_scale.scrollTo(m_scale.firstVisible() - distance / m_scale.pixelsPerFrame());
        viewChanged();
        return;
    }
    setCurrent(arcAt(m_pointer));
    setCursor(m_current ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void ArcView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool wasClick = std::exchange(m_isPressed, false) && !std::exchange(m_isDragging, false);
    if (!wasClick || event->button() != Qt::LeftButton)
        return;
    if (const auto place = arcAt(event->position())) {
        setCurrent(place);
        emit arcActivated(place->arc.from, place->arc.to);
    }
}

void ArcView::leaveEvent(QEvent* /*event*/)
{
    if (!hasFocus())
        setCurrent({});
}

void ArcView::step(int count)
{
    const Side side = m_current ? m_current->side : (shown(Side::Above).empty() ? Side::Below : Side::Above);
    const auto& bundles = shown(side);
    if (bundles.empty())
        return;
    const auto at = std::find_if(bundles.begin(), bundles.end(), [this](const ArcBundle& bundle) {
        return m_current && bundle.lightest == m_current->arc;
    });
    const auto last = static_cast<int>(bundles.size()) - 1;
    const int index = at == bundles.end()
                          ? (count > 0 ? 0 : last)
                          : std::clamp(static_cast<int>(at - bundles.begin()) + count, 0, last);
    setCurrent(Place{side, bundles[static_cast<std::size_t>(index)].lightest});
}

void ArcView::changeSide(Side side)
{
    const auto& bundles = shown(side);
    if (bundles.empty())
        return;
    const Arc before = m_current ? m_current->arc : bundles.front().lightest;
    const auto nearest =
        std::min_element(bundles.begin(), bundles.end(), [&](const ArcBundle& a, const ArcBundle& b) {
            const auto away = [&](const Arc& arc) {
                return std::abs(arc.from - before.from) + std::abs(arc.to - before.to);
            };
            return away(a.lightest) < away(b.lightest);
        });
    setCurrent(Place{side, nearest->lightest});
}

void ArcView::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    const bool isZoom = key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus;
    const bool isReturn = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (!isEmpty() && (key == Qt::Key_Left || key == Qt::Key_Right)) {
        step(key == Qt::Key_Left ? -1 : 1);
    } else if (!isEmpty() && (key == Qt::Key_Up || key == Qt::Key_Down)) {
        changeSide(key == Qt::Key_Up ? Side::Above : Side::Below);
    } else if (!isEmpty() && isZoom) {
        zoomBy(key == Qt::Key_Minus ? 1 / chartKeyZoom : chartKeyZoom);
    } else if (!isEmpty() && key == Qt::Key_0) {
        m_scale.fit();
        viewChanged();
    } else if (isReturn && m_current) {
        emit arcActivated(m_current->arc.from, m_current->arc.to);
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace quadrille::widgets

#include "moc_arcview.cpp"
