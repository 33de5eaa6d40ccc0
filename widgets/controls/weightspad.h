// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QPointF>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// A square in which a point is dragged between four named corners: two shares from 0 to 1 at once, x to the
/// right and y upwards. Arrows move it by a hundredth, with Shift by a tenth; Home and End, Page Down and
/// Page Up go to the ends; Escape gives a drag up.
class WeightsPad : public QWidget
{
    Q_OBJECT

public:
    explicit WeightsPad(QWidget* parent = nullptr);

    /// \param names  of (0, 0), (1, 0), (0, 1) and (1, 1).
    void setCorners(const std::array<QString, 4>& names);
    const std::array<QString, 4>& corners() const { return m_corners; }
    /// Places to lie at best: they are marked, and the point clings to them while it is dragged near.
    void setNodes(std::vector<QPointF> nodes);
    /// Ignored while the point is dragged. Values beyond 0 … 1 are brought back.
    void setWeights(const QPointF& weights);
    QPointF weights() const { return m_weights; }
    bool isDragged() const { return m_before.has_value(); }
    /// Pixels.
    QPointF positionOf(const QPointF& weights) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user moved the point. \param isFinal  false while it is dragged.
    void edited(const QPointF& weights, bool isFinal);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    QRectF square() const;
    QPointF weightsAt(const QPointF& position) const;
    void move(const QPointF& weights, bool isFinal);
    void paintNames(QPainter& painter) const;
    void tellValue();

    std::array<QString, 4> m_corners;
    std::vector<QPointF> m_nodes;
    QPointF m_weights;
    std::optional<QPointF> m_before; ///< where the drag began
};

} // namespace quadrille::widgets
