// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/parametric/motionspace.h"

#include <QWidget>
#include <memory>
#include <optional>

namespace quadrille {

/// Where the takes of a motion space lie on the axes of its parameters, and what lies between them: the
/// intervals, triangles or tetrahedra that are blended, of three parameters the first two. What they do not
/// cover is a hole. Below stand the shares of the takes at the pointer, else at the place that is played.
class SpaceMap : public QWidget
{
    Q_OBJECT

public:
    explicit SpaceMap(QWidget* parent = nullptr);

    /// Null empties it.
    void setSpace(std::shared_ptr<const MotionSpace> space);
    /// A place that is played; none where another space is.
    void setPlayed(const std::optional<SpacePoint>& place);
    /// Whether pressing and dragging wants parameters.
    void setEditable(bool editable);
    /// Pixels. \pre There is a space.
    QPointF positionOf(const SpacePoint& place) const;
    /// What stands below.
    QString sharesText() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    /// The user wants the parameters of the space to be so; a third one as it is played.
    void wanted(const quadrille::SpacePoint& parameters);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    bool isFlat() const { return m_space == nullptr || m_space->weights.dimension() < 2; }
    QRectF area() const;
    SpacePoint placeAt(const QPointF& position) const;
    void paintSimplices(QPainter& painter) const;
    void paintTakes(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    /// The point that shares are told of.
    std::optional<SpacePoint> told() const;

    std::shared_ptr<const MotionSpace> m_space;
    std::optional<SpacePoint> m_played;
    std::optional<SpacePoint> m_pointed;
    bool m_isEditable = false;
};

} // namespace quadrille
