// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timeline.h"

#include <QWidget>
#include <utility>

namespace quadrille::widgets {

/// The frames of a take with two ends that choose some of them, over its labels. It changes nothing itself:
/// edits are signals, and come back by setRange(). While an end is dragged, signals come with `committed`
/// false, at the end once with true; Escape ends with the old values.
///
/// ← → move the end that is active (Page Up and Down by ten frames), Up and Down activate the other one,
/// Ctrl+← → move both.
class RangeStrip : public QWidget
{
    Q_OBJECT

public:
    explicit RangeStrip(QWidget* parent = nullptr);

    void setFrameCount(int frames);
    int frameCount() const { return m_frames; }
    /// Both included. Emits nothing.
    void setRange(int first, int last);
    std::pair<int, int> range() const { return {m_first, m_last}; }
    /// Behind the range, e.g. what is labelled.
    void setSpans(std::vector<TimelineSpan> spans);
    /// Where an end is taken hold of.
    QPoint startHandle() const;
    QPoint endHandle() const;
    /// Kept inside the frames there are.
    int frameAt(int x) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void rangeEdited(int first, int last, bool committed);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Part
    {
        None,
        Start,
        End,
        Both
    };

    double xOf(int frame) const;
    Part partAt(const QPointF& position) const;
    void moveTo(Part part, int first, int last, bool committed);
    void finishDrag(bool commit);

    int m_frames = 1;
    int m_first = 0;
    int m_last = 0;
    std::vector<TimelineSpan> m_spans;
    Part m_active = Part::Start;
    Part m_dragged = Part::None;
    int m_grabbed = 0;
    std::pair<int, int> m_before;
};

} // namespace quadrille::widgets
