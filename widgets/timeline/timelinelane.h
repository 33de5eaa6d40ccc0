// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timeline.h"

#include <QWidget>

namespace quadrille::widgets {

/// A row of its own below a timeline, over the same frames: it follows the timeline's zoom and playhead. Its
/// times are seconds from the first frame.
class TimelineLane : public QWidget
{
    Q_OBJECT

public:
    /// \param timeline  outlives the lane.
    explicit TimelineLane(Timeline& timeline, QWidget* parent = nullptr);

    void setFps(double fps);
    double fps() const { return m_fps; }
    /// What stands on the left, and what the lane says while it is empty.
    void setTexts(const QString& title, const QString& notice);
    /// Pixels of this widget; secondsAt() is the way back.
    double xOf(double seconds) const;
    double secondsAt(double x) const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void menuRequested(double seconds, const QPoint& globalPosition);

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    /// Paints what the lane holds, right of its title.
    virtual void paintContent(QPainter& painter, const QRectF& area) = 0;
    virtual bool isEmpty() const = 0;
    /// What is right of the title, in this widget.
    QRectF area() const;
    double pixelsPerSecond() const;

private:
    Timeline& m_timeline;
    double m_fps = 25;
    QString m_title;
    QString m_notice;
};

} // namespace quadrille::widgets
