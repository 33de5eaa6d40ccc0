// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QImage>
#include <QPainterPath>
#include <QWidget>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// A take in the overview.
struct TakeNode
{
    QString name;
    QColor color;
    QImage picture; ///< may be null
};

/// How many edges lead from one take to another, or from frames of a take to others of it.
struct TakeLink
{
    int from = 0;
    int to = 0;
    int count = 0;
    bool operator==(const TakeLink&) const = default;
};

/// Takes as nodes on a ring, with pictures and names; the edges between them counted, as arrows that are the
/// broader the more there are. What is chosen stands out, the rest is faint.
///
/// A click on a node or an arrow chooses it, with Ctrl a node is added to those that are chosen or taken from
/// them; a click beside all chooses nothing. Keys: ← → go from node to node, Space and Return choose, with
/// Ctrl as above, Esc chooses nothing.
class TakeGraphView : public QWidget
{
    Q_OBJECT

public:
    explicit TakeGraphView(QWidget* parent = nullptr);

    /// Takes all links away.
    void setNodes(std::vector<TakeNode> nodes);
    /// One for each node, in their order.
    void setPictures(const std::vector<QImage>& pictures);
    /// Ends are nodes by their places.
    /// \param title  of what is counted, e.g. "Essential graph".
    void setLinks(const QString& title, std::vector<TakeLink> links);
    const std::vector<TakeLink>& links() const { return m_links; }
    /// Emits nothing.
    void setChosen(std::vector<int> nodes);
    const std::vector<int>& chosen() const { return m_chosen; }
    void setEmptyText(const QString& text);

    int nodeAt(const QPointF& position) const; ///< −1 for none
    /// None where no arrow is near; edges inside of a take belong to its node.
    std::optional<TakeLink> linkAt(const QPointF& position) const;
    /// Where things are drawn, in this widget's coordinates.
    QRectF nodeRect(int node) const;
    QPointF linkMiddle(const TakeLink& link) const;
    /// How broad a link is drawn, logical pixels.
    double linkWidth(const TakeLink& link) const;
    /// "walk 1 → run 2: 14 transitions".
    QString linkText(const TakeLink& link) const;

    QSize sizeHint() const override { return {640, 480}; }
    QSize minimumSizeHint() const override { return {240, 200}; }

signals:
    /// The user chose these nodes; none for all.
    void chosenByUser(const std::vector<int>& nodes);
    /// What can be done with a node, then `from` and `to` are the same, or with a link.
    void menuRequested(int from, int to, const QPoint& globalPosition);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    QPointF middleOf(int node) const;
    bool isRow() const;
    double pictureSide() const;
    /// Half an ellipse's axes on which the nodes lie.
    QSizeF ring() const;
    QPainterPath pathOf(const TakeLink& link) const;
    const TakeLink* loopOf(int node) const;
    bool stands(const TakeLink& link) const; ///< whether it is among what is chosen
    bool stands(int node) const;
    void choose(std::vector<int> nodes);
    void chooseNode(int node, bool toggles);
    void setCurrent(int node);
    void setHovered(int node, const std::optional<TakeLink>& link);
    void paintLink(QPainter& painter, const TakeLink& link) const;
    void paintCount(QPainter& painter, const TakeLink& link) const;
    void paintNode(QPainter& painter, int node) const;

    std::vector<TakeNode> m_nodes;
    std::vector<TakeLink> m_links;
    QString m_title;
    QString m_emptyText;
    std::vector<int> m_chosen;
    int m_current = -1; ///< by keyboard
    int m_hoveredNode = -1;
    std::optional<TakeLink> m_hoveredLink;
};

} // namespace quadrille::widgets
