// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/handletool.h"
#include "widgets/tools/surfacecurvedrag.h"
#include "widgets/tools/surfacecurvedrawing.h"

namespace quadrille::widgets {

struct SurfaceCurveLook;

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

    /// The figure that all curves lie on; −1: none, and nothing is shown.
    void setFigure(int figure);
    int figure() const { return m_figure; }
    /// \pre their vertices are some of the figure's.
    void setCurves(std::vector<ShownCurve> curves);
    const std::vector<ShownCurve>& curves() const { return m_content.curves; }
    /// The curve that points are added to; −1: one that is not there yet.
    void setDrawn(int curve)
    {
        m_content.drawn = curve;
        emit repaintRequested();
    }
    int drawn() const { return m_content.drawn; }
    /// The piece from the last point to the pointer, while drawing.
    void setPreview(std::vector<std::uint32_t> vertices)
    {
        m_content.preview = std::move(vertices);
        emit repaintRequested();
    }
    /// Why the last gesture could not be done, in the view until the next one; empty for nothing.
    void setRefusal(const QString& text)
    {
        m_refusal = text;
        emit repaintRequested();
    }
    const QString& refusal() const { return m_refusal; }
    /// Shows nothing and uses no events while false.
    void setActive(bool active);
    bool isActive() const { return m_active; }
    void setMode(Mode mode);
    Mode mode() const { return m_mode; }
    void setSelected(const SurfaceCurvePart& part);
    const SurfaceCurvePart& selected() const { return m_content.selected; }
    bool isDragging() const override { return m_drag.has_value(); }
    bool isDrawing() const override { return m_mode == Mode::Draw; }
    /// Where a point is on the view, also behind the body; none where it is not there.
    std::optional<QPointF> pixelOf(const SurfaceCurvePart& part) const
    {
        const auto shown = layout();
        return shown ? shown->pixelOf(part) : std::nullopt;
    }
    /// Whether a point is on the side of the figure that is seen.
    bool isSeen(const SurfaceCurvePart& part) const
    {
        const auto shown = layout();
        return shown && shown->isSeen(part);
    }
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
    /// Return was pressed on it: to be looked at closer. \param curve  its place among curves().
    void activated(int curve);
    void contextMenuRequested(const quadrille::widgets::SurfaceCurvePart& part, const QPoint& globalPosition);

protected:
    void viewChanged() override
    {
        m_seen.reset();
        m_drawing.leave();
    }
    bool isReady() const override { return m_active && layout(); }
    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool doubleClick(const QMouseEvent& event) override;
    void leave() override;
    bool wantsKey(const QKeyEvent& event) const override;
    void endDrag(bool commit) override;
    void leaveDrawing() override { setMode(Mode::Edit); }
    void clearSelection() override { setSelected({}); }
    void confirm() override;
    void insertByKey() override;
    void askMenuByKey() override;
    bool removeByKey() override;
    bool selectNext(int step) override;
    bool pressOther(const QKeyEvent& event) override;

private:
    /// None where there is no figure to look at.
    std::optional<SurfaceCurveLayout> layout() const;
    SurfaceCurveLook look() const;
    bool pressPart(const QMouseEvent& event);
    void hover(const QMouseEvent& event);
    void hoverDrawing(const QMouseEvent& event);
    void clickWhileDrawing(const QMouseEvent& event);
    void finishDrawing();
    /// Asks for a point at a pixel of a curve.
    void insertInto(int curve, const QMouseEvent& event);
    void insertAfter(const SurfaceCurvePart& part, const SurfacePlace& place);
    void nudge(const QKeyEvent& event);

    Viewport& m_viewport;
    int m_figure = -1;
    SurfaceCurveContent m_content;
    mutable SeenVertices m_seen;
    bool m_active = true;
    Mode m_mode = Mode::Edit;
    QString m_refusal;
    SurfaceCurvePart m_hovered;
    std::optional<SurfaceCurveDrag> m_drag;
    SurfaceCurveDrawing m_drawing;
    std::optional<QPointF> m_pressedAt; ///< of a press that was left to the camera
    bool m_isMenuPress = false;         ///< the right button is down on a part
};

} // namespace quadrille::widgets
