// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/controls/textureview.h"

#include <optional>

namespace quadrille::widgets {

/// A brush for textures.
struct TextureBrush
{
    double radius = 0.02; ///< in widths of the texture
    bool erases = false;

    bool operator==(const TextureBrush&) const = default;
};

/// A texture beside another one: a line with a handle parts them and is dragged to and fro. Maybe a tint over
/// it, which a brush paints. Keys beside those of TextureView: with Shift, ← and → move the line, Home and
/// End take it to an edge; with a brush, arrows move that, Space paints at its place, and the middle mouse
/// button moves the texture.
class ComparedView : public TextureView
{
    Q_OBJECT

public:
    explicit ComparedView(QWidget* parent = nullptr);

    /// What is right of the line; null: no line. \pre It has the texture's size.
    void setOther(TexturePicture other);
    const QImage& other() const { return m_other.image; }
    /// What stands at the two sides of the line.
    void setSides(const QString& left, const QString& right);
    /// Where the line is, from 0 at the left edge of the texture to 1. Emits nothing.
    void setSplit(double split);
    double split() const { return m_split; }

    /// Drawn over the texture, such as a mask; stretched to its size. Null for none.
    void setTint(QImage tint);
    const QImage& tint() const { return m_tint; }
    /// While there is a brush, the left mouse button paints.
    void setBrush(std::optional<TextureBrush> brush);
    const std::optional<TextureBrush>& brush() const { return m_brush; }
    /// Where the brush is, in texture coordinates.
    QPointF brushPlace() const { return m_brushPlace; }

signals:
    void splitMoved(double split);
    /// \param points  of the whole stroke, texture coordinates. \param committed  false while it is painted.
    void strokePainted(const QList<QPointF>& points, bool committed);
    /// Escape was pressed while a stroke was painted: there is none.
    void strokeCancelled();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintOver(QPainter& painter) override;

private:
    enum class Gesture
    {
        None,
        Splitting,
        Painting
    };

    bool isOnLine(const QPointF& position) const;
    bool isOurKey(const QKeyEvent& key) const;
    void moveSplit(double split);
    void moveBrush(const QPointF& place);
    void paintSides(QPainter& painter, double line) const;
    void paintBrush(QPainter& painter) const;

    TexturePicture m_other;
    QString m_left;
    QString m_right;
    double m_split = 0.5;
    QImage m_tint;
    std::optional<TextureBrush> m_brush;
    QPointF m_brushPlace{0.5, 0.5};
    bool m_isBrushSeen = false;
    QList<QPointF> m_stroke;
    Gesture m_gesture = Gesture::None;
};

} // namespace quadrille::widgets
