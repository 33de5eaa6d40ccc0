// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/handletool.h"
#include "widgets/tools/showncurve.h"

#include <memory>
#include <optional>

namespace quadrille::widgets {

/// Draws and edits closed curves on a figure's surface. It changes nothing itself: gestures are signals, and
/// what becomes of them comes back by setCurves(). Curves behind the body are thin and dashed; what is wrong
/// with one has a sign, a colour and words.
///
/// Drawing: a click adds a point, the piece to the pointer is shown before; a click on the first point, a
/// double click or Return ends, Backspace takes the last point back, Escape leaves; a drag turns the view.
/// Editing: points are dragged (Alt: without snapping), Ctrl+click or a double click on a curve inserts one,
/// Delete removes it, or the curve that is selected. By keyboard: Tab walks over all points, arrows move the
/// selected one to the next vertex that way; while drawing, arrows move a cursor over the surface (Shift by
/// five vertices) and Insert adds a point there.
class SurfaceCurveEditor : public HandleTool
{
    Q_OBJECT
public:
    enum class Mode
    {
        Edit,
        Draw
    };

    /// \param viewport  what it draws into; it is to be made the viewport's tool by setViewTool().
    explicit SurfaceCurveEditor(Viewport& viewport, QObject* parent = nullptr);
    ~SurfaceCurveEditor() override;

    /// The figure that all curves lie on; −1: none, and nothing is shown.
    void setFigure(int figure);
    int figure() const;
    /// \pre their vertices are some of the figure's.
    void setCurves(std::vector<ShownCurve> curves);
    const std::vector<ShownCurve>& curves() const;
    /// The curve that points are added to; −1: one that is not there yet.
    void setDrawn(int curve);
    int drawn() const;
    /// The piece from the last point to the pointer, while drawing.
    void setPreview(std::vector<std::uint32_t> vertices);
    /// Why the last gesture could not be done, in the view until the next one; empty for nothing.
    void setRefusal(const QString& text);
    const QString& refusal() const;
    /// Shows nothing and uses no events while false.
    void setActive(bool active);
    bool isActive() const;
    void setMode(Mode mode);
    Mode mode() const;
    void setSelected(const SurfaceCurvePart& part);
    const SurfaceCurvePart& selected() const;
    bool isDragging() const override;
    bool isDrawing() const override;
    /// Where a point is on the view, also behind the body; none where it is not there.
    std::optional<QPointF> pixelOf(const SurfaceCurvePart& part) const;
    /// Whether a point is on the side of the figure that is seen.
    bool isSeen(const SurfaceCurvePart& part) const;
    /// What would be taken hold of here.
    SurfaceCurvePart partAt(const QPointF& position) const;
    /// Turns the view so that a point, or the first of a curve, can be seen.
    void reveal(const SurfaceCurvePart& part);
    /// What Delete does, for menus.
    void removeSelected();

    void paint(QPainter& painter) const override;

signals:
    void modeChanged(quadrille::widgets::SurfaceCurveEditor::Mode mode);
    void selectionChanged(const quadrille::widgets::SurfaceCurvePart& part);
    /// While drawing: the pointer is over the figure, or over nothing.
    void pointerMoved(const std::optional<quadrille::widgets::SurfacePlace>& place);
    void pointAdded(const quadrille::widgets::SurfacePlace& place);
    void lastPointRemovalRequested();
    /// The curve that is drawn is complete; comes before the mode changes.
    void drawingFinished();
    /// \param committed  false while it is dragged, at the end once true.
    void pointMoved(int curve, int point, const quadrille::widgets::SurfacePlace& place, bool committed);
    /// Escape ended a drag: all is to be as it was before.
    void moveCancelled(int curve);
    /// \param after  the point that it comes after.
    void pointInserted(int curve, int after, const quadrille::widgets::SurfacePlace& place);
    void pointRemovalRequested(int curve, int point);
    void curveRemovalRequested(int curve);
    /// Return was pressed on it: to be looked at closer.
    void activated(int curve);
    void contextMenuRequested(const quadrille::widgets::SurfaceCurvePart& part, const QPoint& globalPosition);

protected:
    void viewChanged() override;
    bool isReady() const override;
    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool doubleClick(const QMouseEvent& event) override;
    void leave() override;
    bool wantsKey(const QKeyEvent& event) const override;
    void endDrag(bool commit) override;
    void leaveDrawing() override;
    void clearSelection() override;
    void confirm() override;
    void insertByKey() override;
    void askMenuByKey() override;
    bool removeByKey() override;
    bool selectNext(int step) override;
    bool pressOther(const QKeyEvent& event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
    void hover(const QMouseEvent& event);
    void clickWhileDrawing(const QMouseEvent& event);
    void dragTo(const QMouseEvent& event);
    void finishDrawing();
    void insertAt(const SurfaceCurvePart& part, const SurfacePlace& place);
    void nudge(int key, Qt::KeyboardModifiers modifiers);
    void moveCursor(int key, Qt::KeyboardModifiers modifiers);
};

} // namespace quadrille::widgets
