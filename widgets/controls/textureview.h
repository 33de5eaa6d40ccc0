// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QLineF>
#include <QList>
#include <QWidget>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace quadrille::widgets {

/// A picture with smaller copies of itself, so that it looks smooth however far it is zoomed out.
struct TexturePicture
{
    QImage image;
    std::vector<QImage> halves; ///< each half as wide and high as the one before; may be empty
};

/// Makes the smaller copies. Takes about 10 ms for each four megapixels; on any thread.
TexturePicture prepareTexture(const QImage& image);

/// Shows a texture over a checkerboard and maybe the edges of the mesh in UV space, to be zoomed with the
/// wheel and moved by dragging. Texture coordinates have their origin at the lower left, v up; pixels are
/// counted from the upper left. Keys: + and − zoom, 0 shows each pixel as one of the screen, F fits the
/// texture into the view, arrows move it where it is larger than the view.
class TextureView : public QWidget
{
    Q_OBJECT

public:
    explicit TextureView(QWidget* parent = nullptr);

    /// Shows another picture, a null one for none; one of the same size leaves the view where it is.
    void setPicture(TexturePicture picture);
    const QImage& image() const { return m_picture.image; }
    /// Lines in texture coordinates drawn over the picture. Without a picture they are drawn over the square
    /// that all coordinates from 0 to 1 make. They are drawn into a picture once for each zoom and place.
    void setUvEdges(QList<QLineF> edges);
    const QList<QLineF>& uvEdges() const { return m_edges; }
    /// What stands in the middle while there is neither a picture nor edges.
    void setEmptyText(const QString& text);
    /// A button below that text which helps to get a texture. Taken over.
    void setEmptyAction(QWidget* action);
    /// Whether there is neither a picture nor edges.
    bool isEmpty() const { return m_picture.image.isNull() && m_edges.isEmpty(); }

    /// Pixels of the screen for each pixel of the texture: 1 is 100 %.
    double zoom() const;
    bool isFitted() const { return m_isFitted; }
    /// Makes the texture larger or smaller; what is at `position` stays there; in pixels of this widget. It
    /// is not fitted any more.
    void zoomAbout(const QPointF& position, double factor);
    /// Fits it into the view, and keeps it so when the view gets another size.
    void fit();
    /// A pixel of the texture for each of the screen.
    void showActualSize();
    /// Shows the same part of its texture as another view of one size does.
    void showLike(const TextureView& other);

    /// Where texture coordinates are drawn, in logical pixels of this widget; uvAt() is the way back.
    QPointF positionOf(const QPointF& uv) const;
    QPointF uvAt(const QPointF& position) const;
    /// The pixel of the texture at a place of this widget; may lie outside of the picture.
    QPoint pixelAt(const QPointF& position) const;

    QSize sizeHint() const override { return {280, 280}; }
    QSize minimumSizeHint() const override { return {160, 60}; }

signals:
    void zoomChanged(double zoom);
    /// The user or `fit` moved or zoomed the texture; not `showLike`.
    void viewMoved();
    /// The pointer is over the texture.
    void hovered(const QPointF& uv, const QPoint& pixel);
    /// The pointer has left the texture.
    void hoverEnded();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

    /// Where the texture lies, in logical pixels of this widget.
    QRectF textureRect() const;
    /// Draws a picture of the texture's size in its place, what is seen of it.
    void paintPicture(QPainter& painter, const TexturePicture& picture) const;
    /// Drawn over the picture and below edges.
    virtual void paintOver(QPainter& /*painter*/) {}

private:
    QSizeF textureSize() const;
    double fittingScale() const;
    void setScale(double scale, const QPointF& origin);
    void moveBy(const QPointF& distance);
    void keepInView();
    void viewChanged();
    void contentChanged();
    bool mayMove(int key) const;
    void reportHover(const QPointF& position);
    void paintContent(QPainter& painter);
    void paintPixelGrid(QPainter& painter) const;
    void updateEdgeImage();

    TexturePicture m_picture;
    QList<QLineF> m_edges;
    double m_scale = 1; ///< logical pixels of the screen for each pixel of the texture
    QPointF m_origin;   ///< where the upper left corner of the texture is
    QPointF m_pointer;  ///< where the pointer was last
    bool m_isDragging = false;
    bool m_isFitted = true;
    bool m_isHovered = false;
    QImage m_edgeImage; ///< the edges as they are seen now; null when they have to be drawn again
    QWidget* m_empty;
    QLabel* m_emptyText;
    QVBoxLayout* m_emptyColumn;
};

} // namespace quadrille::widgets
