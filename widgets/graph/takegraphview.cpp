// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "widgets/graph/takegraphview.h"

#include "widgets/theme/theme.h"

#include <QAccessible>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainterPathStroker>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace quadrille::widgets {

namespace {

constexpr double largestPicture = 64; // logical pixels
constexpr double smallestPicture = 20;
constexpr double graphMargin = 8;
constexpr double linkReach = 10; // breadth about a link that takes hold of it
constexpr double bend = 0.16;    // of the distance between two nodes, to the right of the way
constexpr double broadest = 9;   // of links
constexpr double narrowest = 1.2;

double length(const QPointF& vector)
{
    return std::hypot(vector.x(), vector.y());
}

} // namespace

TakeGraphView::TakeGraphView(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("takeGraphView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TakeGraphView::setNodes(std::vector<TakeNode> nodes)
{
    m_nodes = std::move(nodes);
    m_links.clear();
    m_chosen.clear();
    m_current = -1;
    setHovered(-1, {});
    update();
}

void TakeGraphView::setPictures(const std::vector<QImage>& pictures)
{
    for (std::size_t i = 0; i < std::min(pictures.size(), m_nodes.size()); ++i)
        m_nodes[i].picture = pictures[i];
    update();
}

void TakeGraphView::setLinks(const QString& title, std::vector<TakeLink> links)
{
    m_title = title;
    m_links = std::move(links);
    setHovered(-1, {});
    update();
}

void TakeGraphView::setChosen(std::vector<int> nodes)
{
    m_chosen = std::move(nodes);
    update();
}

void TakeGraphView::setEmptyText(const QString& text)
{
    m_emptyText = text;
    update();
}

double TakeGraphView::pictureSide() const
{
    // Nodes in a row on the ring keep a picture's breadth between them.
    const double around = std::numbers::pi * (width() + height()) / 2;
    const auto count = static_cast<double>(std::max<std::size_t>(m_nodes.size(), 1));
    // And those above each other keep the name and a count between them.
    const double line = QFontMetricsF(font()).height();
    const double rows = m_nodes.size() < 2 || isRow() ? 1 : 2;
    const double room = (height() - 2 * line - graphMargin) / rows - 2 * line;
    return std::clamp(std::min(around / count / 2.6, room), smallestPicture, largestPicture);
}

/// Two nodes stand beside each other where there is more room across.
bool TakeGraphView::isRow() const
{
    return m_nodes.size() == 2 && width() > height();
}

QSizeF TakeGraphView::ring() const
{
    const QFontMetricsF metrics(font());
    double widest = pictureSide();
    for (const TakeNode& node : m_nodes)
        widest = std::max(widest, std::min(metrics.horizontalAdvance(node.name), 2 * largestPicture));
    const double across = (width() - widest) / 2 - 2 * graphMargin;
    const double down = (height() - pictureSide() - metrics.height()) / 2 - metrics.height() - graphMargin;
    return {std::max(across, 16.0), std::max(down, 16.0)};
}

QPointF TakeGraphView::middleOf(int node) const
{
    const QPointF centre(width() / 2.0, (height() + QFontMetricsF(font()).height()) / 2.0 - graphMargin);
    if (m_nodes.size() < 2)
        return centre;
    const double first = isRow() ? -std::numbers::pi / 2 : 0;
    const double angle = first + 2 * std::numbers::pi * node / static_cast<double>(m_nodes.size());
    const QSizeF axes = ring();
    return centre + QPointF(axes.width() * std::sin(angle), -axes.height() * std::cos(angle));
}

QRectF TakeGraphView::nodeRect(int node) const
{
    const double side = pictureSide();
    return {middleOf(node) - QPointF(side / 2, side / 2), QSizeF(side, side)};
}

/// From the edge of one node to that of the other, bent to the right so that both directions show.
QPainterPath TakeGraphView::pathOf(const TakeLink& link) const
{
    const QPointF from = middleOf(link.from);
    const QPointF to = middleOf(link.to);
    const QPointF way = to - from;
    const double distance = std::max(length(way), 1.0);
    const QPointF right(-way.y() / distance, way.x() / distance);
    const QPointF control = (from + to) / 2 + right * (bend * distance);
    const double reach = pictureSide() * 0.62;
    const auto towards = [reach](const QPointF& start, const QPointF& end) {
        return start + (end - start) * (reach / std::max(length(end - start), reach));
    };
    QPainterPath path(towards(from, control));
    path.quadTo(control, towards(to, control));
    return path;
}

QPointF TakeGraphView::linkMiddle(const TakeLink& link) const
{
    if (link.from == link.to)
        return nodeRect(link.from).topRight();
    return pathOf(link).pointAtPercent(0.5);
}

double TakeGraphView::linkWidth(const TakeLink& link) const
{
    int most = 1;
    for (const TakeLink& each : m_links) {
        if (each.from != each.to)
            most = std::max(most, each.count);
    }
    return narrowest + (broadest - narrowest) * link.count / most;
}

const TakeLink* TakeGraphView::loopOf(int node) const
{
    const auto found = std::ranges::find_if(
        m_links, [node](const TakeLink& link) { return link.from == node && link.to == node; });
    return found == m_links.end() ? nullptr : &*found;
}

QString TakeGraphView::linkText(const TakeLink& link) const
{
    const QString& from = m_nodes[static_cast<std::size_t>(link.from)].name;
    const QString& to = m_nodes[static_cast<std::size_t>(link.to)].name;
    //: two takes; how many transitions lead from the first to the second
    return tr("%1 → %2: %n transition(s)", nullptr, link.count).arg(from, to);
}

int TakeGraphView::nodeAt(const QPointF& position) const
{
    const double line = QFontMetricsF(font()).height();
    for (int node = 0; node < static_cast<int>(m_nodes.size()); ++node) {
        if (nodeRect(node).adjusted(-2, -2, 2, line).contains(position))
            return node;
    }
    return -1;
}

std::optional<TakeLink> TakeGraphView::linkAt(const QPointF& position) const
{
    for (const TakeLink& link : m_links) {
        if (link.from == link.to)
            continue;
        QPainterPathStroker stroker;
        stroker.setWidth(std::max(linkWidth(link), linkReach));
        if (stroker.createStroke(pathOf(link)).contains(position))
            return link;
    }
    return std::nullopt;
}

bool TakeGraphView::stands(int node) const
{
    return m_chosen.empty() || std::ranges::count(m_chosen, node) > 0;
}

bool TakeGraphView::stands(const TakeLink& link) const
{
    if (m_chosen.size() == 1)
        return link.from == m_chosen.front() || link.to == m_chosen.front();
    return stands(link.from) && stands(link.to);
}

void TakeGraphView::choose(std::vector<int> nodes)
{
    if (nodes == m_chosen)
        return;
    setChosen(std::move(nodes));
    emit chosenByUser(m_chosen);
}

void TakeGraphView::chooseNode(int node, bool toggles)
{
    if (!toggles) {
        const bool isAlone = m_chosen == std::vector<int>{node};
        choose(isAlone ? std::vector<int>() : std::vector<int>{node});
        return;
    }
    std::vector<int> nodes = m_chosen;
    if (std::erase(nodes, node) == 0)
        nodes.push_back(node);
    choose(std::move(nodes));
}

void TakeGraphView::setCurrent(int node)
{
    m_current = node;
    setAccessibleDescription(node < 0 ? QString() : m_nodes[static_cast<std::size_t>(node)].name);
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    update();
}

void TakeGraphView::setHovered(int node, const std::optional<TakeLink>& link)
{
    if (node == m_hoveredNode && link == m_hoveredLink)
        return;
    m_hoveredNode = node;
    m_hoveredLink = link;
    setCursor(node >= 0 || link ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

bool TakeGraphView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int node = nodeAt(help->pos());
        const auto link = linkAt(help->pos());
        const TakeLink* loop = node >= 0 ? loopOf(node) : nullptr;
        const QString text = loop != nullptr ? linkText(*loop)
                             : node >= 0     ? m_nodes[static_cast<std::size_t>(node)].name
                             : link          ? linkText(*link)
                                             : QString();
        QToolTip::showText(help->globalPos(), text, this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride && !m_nodes.empty()) {
        // These keys mean something else in the window: here they are for the nodes.
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool isEscape = key == Qt::Key_Escape && !m_chosen.empty();
        if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Space || isEscape) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void TakeGraphView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_nodes.empty()) {
        event->ignore();
        return;
    }
    const int node = nodeAt(event->position());
    if (node >= 0) {
        setCurrent(node);
        chooseNode(node, event->modifiers().testFlag(Qt::ControlModifier));
    } else if (const auto link = linkAt(event->position())) {
        choose({link->from, link->to});
    } else {
        choose({});
    }
}

void TakeGraphView::mouseMoveEvent(QMouseEvent* event)
{
    const int node = nodeAt(event->position());
    setHovered(node, node >= 0 ? std::nullopt : linkAt(event->position()));
}

void TakeGraphView::contextMenuEvent(QContextMenuEvent* event)
{
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard;
    if (isByKey && m_current >= 0) {
        emit menuRequested(m_current, m_current, mapToGlobal(nodeRect(m_current).center().toPoint()));
        return;
    }
    const int node = nodeAt(event->pos());
    const auto link = linkAt(event->pos());
    if (!isByKey && node >= 0)
        emit menuRequested(node, node, event->globalPos());
    else if (!isByKey && link)
        emit menuRequested(link->from, link->to, event->globalPos());
    else
        event->ignore();
}

void TakeGraphView::leaveEvent(QEvent* /*event*/)
{
    setHovered(-1, {});
}

void TakeGraphView::keyPressEvent(QKeyEvent* event)
{
    const int count = static_cast<int>(m_nodes.size());
    const int key = event->key();
    if (count > 0 && (key == Qt::Key_Left || key == Qt::Key_Right)) {
        const int step = key == Qt::Key_Left ? count - 1 : 1;
        setCurrent(m_current < 0 ? 0 : (m_current + step) % count);
    } else if ((key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter) && m_current >= 0) {
        chooseNode(m_current, event->modifiers().testFlag(Qt::ControlModifier));
    } else if (key == Qt::Key_Escape && !m_chosen.empty()) {
        choose({});
    } else {
        QWidget::keyPressEvent(event);
    }
}

} // namespace quadrille::widgets

#include "moc_takegraphview.cpp"
