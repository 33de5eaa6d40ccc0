// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/turntable.h"

#include <QObject>
#include <QRectF>
#include <QSizeF>

class QEvent;
class QPainter;

namespace quadrille::widgets {

/// What mouse and keys do in a viewport beside moving the camera and clicking on figures. A viewport shows
/// one at a time; it gets all events of the view first.
class ViewTool : public QObject
{
    Q_OBJECT
public:
    explicit ViewTool(QObject* parent = nullptr) : QObject(parent) {}

    /// Mouse and key events on the view.
    /// \return whether it was used up; what is not moves the camera, clicks, plays.
    virtual bool handle(QEvent& event) = 0;
    /// Draws handles over the picture, in logical pixels of the view.
    virtual void paint(QPainter& painter) const = 0;

    /// How the world appears now; the viewport says it.
    void setView(const Turntable& camera, const QSizeF& size);
    const Turntable& camera() const { return m_camera; }
    const QSizeF& viewSize() const { return m_size; }
    /// Where the viewport has written something that words of the tool are not to cover; empty for nothing.
    void setOccupied(const QRectF& place) { m_occupied = place; }
    const QRectF& occupied() const { return m_occupied; }

signals:
    /// What paint() draws is out of date.
    void repaintRequested();
    void cursorRequested(Qt::CursorShape shape);

protected:
    virtual void viewChanged() {}

private:
    Turntable m_camera;
    QSizeF m_size;
    QRectF m_occupied;
};

} // namespace quadrille::widgets
