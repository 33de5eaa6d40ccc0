// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/timeline/timelinelane.h"

#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Moments below a timeline, such as the keys of a camera: diamonds that are clicked, dragged, and moved by
/// Ctrl+← and Ctrl+→. ← and → choose, Delete asks to remove, Return to go there; a double click on a free
/// place asks for a new one. Moments keep their order and a frame between them. While one is dragged, signals
/// come with `committed` false, at the end once with true; Escape ends with the old value.
class MomentLane : public TimelineLane
{
    Q_OBJECT

public:
    using TimelineLane::TimelineLane;

    /// `momentSelected` is told where the chosen one goes.
    /// \param seconds ascending.
    void setMoments(std::vector<double> seconds);
    const std::vector<double>& moments() const { return m_moments; }
    /// −1 for none. Emits nothing.
    void setSelected(int moment);
    int selected() const { return m_selected; }
    /// \pre There is one.
    QPointF centreOf(int moment) const;

signals:
    /// The user chose it, or the chosen one went; −1 for none.
    void momentSelected(int moment);
    void momentMoved(int moment, double seconds, bool committed);
    void momentActivated(int moment);
    void removalRequested(int moment);
    void additionRequested(double seconds);

protected:
    void paintContent(QPainter& painter, const QRectF& area) override;
    bool isEmpty() const override { return m_moments.empty(); }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drag
    {
        double x = 0;
        double seconds = 0;
        bool hasMoved = false;
    };
    int momentAt(const QPointF& position) const;
    void choose(int moment);
    void move(double seconds, bool committed);

    std::vector<double> m_moments;
    int m_selected = -1;
    std::optional<Drag> m_drag; ///< of the selected one
};

} // namespace quadrille::widgets
