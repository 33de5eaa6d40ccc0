// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QPixmap>
#include <QWidget>
#include <array>
#include <optional>

namespace quadrille::widgets {

/// The three axes of the world as the camera sees them, in a corner of a view. A click on an end looks from
/// there.
class AxesGizmo : public QWidget
{
    Q_OBJECT
public:
    explicit AxesGizmo(QWidget* parent = nullptr);

    void setCamera(const Turntable& camera);
    QSize sizeHint() const override { return {84, 84}; }
    /// Where the end of an axis is, in pixels of this widget; empty where it is hidden behind the other one.
    std::optional<QPointF> endOf(StandardView view) const;

signals:
    /// An end was clicked on.
    void lookRequested(quadrille::widgets::StandardView view);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct End
    {
        StandardView view = StandardView::Front;
        int axis = 0;
        bool isPositive = true;
        QPointF place;
        float nearness = 0; ///< −1 … 1, towards the eye
    };
    std::array<End, 6> ends() const; ///< from the farthest to the nearest
    std::optional<StandardView> viewAt(const QPointF& position) const;
    void drawAnew();
    void draw();
    void retranslate();

    Turntable m_camera;
    std::optional<StandardView> m_hovered;
    QPixmap m_picture; ///< none: to be drawn anew
};

} // namespace quadrille::widgets
