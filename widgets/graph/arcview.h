// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/graph/arclayout.h"
#include "widgets/timeline/timelinescale.h"

#include <QColor>
#include <QPixmap>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::widgets {

/// Frames that follow each other, drawn as a bar.
struct ArcSequence
{
    QString name;
    int frames = 0;
    QColor color;
};

/// Sequences as bars along a line, the edges of one graph as arcs above them, those of another below. Where
/// there are too many to see, arcs that look the same are joined and the lightest between every two sequences
/// are shown.
///
/// Wheel zooms, dragging moves, a click on an arc activates it. Keys: ← → go from arc to arc, ↑ ↓ change the
/// side, + − 0 zoom, Return activates.
class ArcView : public QWidget
{
    Q_OBJECT

public:
    enum class Side
    {
        Above,
        Below
    };
    /// An arc that shows.
    struct Place
    {
        Side side = Side::Above;
        Arc arc;
        bool operator==(const Place&) const = default;
    };

    explicit ArcView(QWidget* parent = nullptr);

    /// Arcs count the frames of all of them, from 0 on. Takes the arcs away that were there.
    void setSequences(std::vector<ArcSequence> sequences);
    /// \param title  of the graph. \param arcs  null for none; frames count as in setSequences(), and are
    /// inside.
    void setArcs(Side side, const QString& title, std::shared_ptr<const std::vector<Arc>> arcs);
    void setEmptyText(const QString& text);
    /// "walk 12 → jog 3: 0.42"; for screen readers and read-outs.
    QString arcText(const Arc& arc) const;

    /// The arc that is named now: hovered, or chosen by keyboard.
    std::optional<Place> currentArc() const;
    /// Bundles that show on a side. They are those of the zoom of now.
    const std::vector<ArcBundle>& shown(Side side) const;
    /// None where no arc is near.
    std::optional<Place> arcAt(const QPointF& position) const;
    /// Where an arc is drawn, in this widget's coordinates.
    ArcCurve curve(Side side, const Arc& arc) const;
    /// Where its bar is drawn; it may reach beyond the widget.
    QRectF sequenceRect(int sequence) const;
    /// More detail above one.
    void zoomBy(double factor);

    QSize sizeHint() const override { return {720, 320}; }
    QSize minimumSizeHint() const override { return {280, 140}; }

signals:
    /// The arc that is named is another one, by the pointer or by keys.
    void arcHovered(int from, int to);
    void hoverEnded();
    /// A click or Return.
    void arcActivated(int from, int to);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct Half
    {
        QString title;
        std::shared_ptr<const std::vector<Arc>> arcs;
        std::vector<ArcBundle> shown;
    };
    const Half& half(Side side) const { return m_halves[static_cast<std::size_t>(side)]; }
    bool isEmpty() const { return m_starts.back() == 0; }
    double barHeight() const;
    double barTop() const;
    double xOf(double frame) const;
    int sequenceOf(int frame) const;
    void viewChanged();
    void setCurrent(const std::optional<Place>& place);
    void step(int count);
    void changeSide(Side side);
    void paintArcs(QPainter& painter) const;
    void paintCurrent(QPainter& painter) const;
    void paintBars(QPainter& painter) const;
    void paintTitles(QPainter& painter) const;

    std::vector<ArcSequence> m_sequences;
    std::vector<int> m_starts{0}; ///< of each sequence, and the end of the last
    std::array<Half, 2> m_halves;
    QString m_emptyText;
    TimelineScale m_scale;
    std::optional<Place> m_current;
    QPixmap m_picture; ///< arcs as they show now; null when they have to be painted again
    QPointF m_pointer;
    QPointF m_pressedAt;
    bool m_isPressed = false;
    bool m_isDragging = false;
};

} // namespace quadrille::widgets
