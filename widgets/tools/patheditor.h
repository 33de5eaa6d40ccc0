// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/tools/handletool.h"
#include "widgets/tools/pathdrag.h"
#include "widgets/tools/pathdrawing.h"

class QKeyEvent;
class QMouseEvent;

namespace quadrille::widgets {

class Viewport;

/// Draws and edits a path in a viewport, in whose unit all lengths are. It changes nothing itself: edits are
/// signals, and come back by setShape(). While something is dragged, signals come with `committed` false, at
/// the end once with true; Escape ends with the old values.
///
/// Drawing: a click adds a point, a stroke is made to few points (Bézier: pulls the handles); a double click,
/// Return or a click on the first point ends. Editing: points, handles, ends of stretches and obstacles are
/// dragged (Shift keeps to an axis, Ctrl snaps to the grid, Alt moves a handle alone, or lifts a point in
/// space), a double click on the curve inserts a point. Tab walks over everything, arrows move it
/// by 10 cm (Shift by 1 m, Ctrl by 1 cm; in feet and inches by an inch, a foot, a tenth of an inch), Page Up
/// and Page Down lift, Insert adds, Delete removes, + and − resize.
class PathEditor : public HandleTool
{
    Q_OBJECT
public:
    using Mode = PathMode;

    /// \param viewport  what it draws into; it is to be made the viewport's tool by setViewTool().
    explicit PathEditor(Viewport& viewport, QObject* parent = nullptr);

    /// Makes the curve of points, also of those that are not yet there. \pre set before any shape.
    void setSampler(PathSampler sampler) { m_sampler = std::move(sampler); }
    /// Emits nothing, but for a selected part that goes. A drag ends where the shape has more or fewer parts
    /// than at its press.
    void setShape(const PathShape& shape);
    const PathShape& shape() const { return m_content.shape; }
    const SampledCurve& curve() const { return m_content.curve; }
    /// Shows nothing and uses no events while false.
    void setActive(bool active);
    bool isActive() const { return m_active; }
    /// Any mode but Edit lets go of the selection. `modeChanged` is told.
    void setMode(Mode mode);
    Mode mode() const { return m_drawing.mode(); }
    void setSelected(const PathPart& part);
    const PathPart& selected() const { return m_content.selected; }
    /// The height above the ground that the first point gets in space.
    void setUsualHeight(float height) { m_drawing.setUsualHeight(height); }
    /// Whether something is being dragged.
    bool isDragging() const override { return m_drag || m_drawing.gesture() != PathDrawing::Gesture::None; }
    bool isDrawing() const override { return m_drawing.isDrawing(); }
    /// Where a part is on the view; none when it is not to be seen or not there.
    std::optional<QPointF> pixelOf(const PathPart& part) const { return layout().pixelOf(part); }
    /// The part that would be dragged from here.
    PathPart partAt(const QPointF& position) const { return layout().partAt(position); }

    /// What double click and Delete do, for menus. Nothing happens without a curve. \param length  along the
    /// curve.
    void insertPoint(double length);
    void removeSelected() { deleteSelected(); }
    /// Puts the handles of the selected point of a Bézier path onto one line. Nothing happens where none is
    /// selected.
    void smoothSelected();

    void paint(QPainter& painter) const override;

signals:
    void modeChanged(quadrille::widgets::PathEditor::Mode mode);
    void selectionChanged(const quadrille::widgets::PathPart& part);
    /// \param points  none: the path goes away.
    void pointsEdited(const std::vector<QVector3D>& points, quadrille::widgets::PathEdit edit,
                      bool committed);
    void stretchEdited(int stretch, double from, double to, bool committed);
    void stretchDeletionRequested(int stretch);
    void obstacleAdded(const quadrille::widgets::PathObstacle& obstacle);
    void obstacleEdited(int obstacle, const quadrille::widgets::PathObstacle& edited, bool committed);
    void obstacleDeletionRequested(int obstacle);
    /// A part was double-clicked, or Return was pressed on it: to be looked at closer.
    void activated(const quadrille::widgets::PathPart& part);
    /// \param length  where on the curve; where there is none under the pointer, 0.
    void contextMenuRequested(const quadrille::widgets::PathPart& part, double length,
                              const QPoint& globalPosition);

protected:
    void viewChanged() override { m_drawing.leave(); }
    bool isReady() const override { return m_active; }
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
    PathLayout layout() const;
    bool pressPart(const QMouseEvent& event);
    void hover(const QMouseEvent& event);
    /// Says what became of a part. \pre it is one of the shape's.
    void emitEdit(const PathPart& part, const PathShape& shape, bool committed);
    void take(const PathDrawing::Outcome& outcome);
    bool finishMode();
    void selectPoint(std::size_t point);
    bool deleteSelected();
    void askMenu(const PathPart& part, const QPointF& position, const QPoint& globalPosition);
    void refreshMarks();

    Viewport& m_viewport;
    PathSampler m_sampler;
    PathContent m_content;
    bool m_active = true;
    PathPart m_hovered;
    std::optional<PathDrag> m_drag;
    PathDrawing m_drawing;
    std::optional<QPointF> m_clickOnNothing; ///< where a press was left to the camera
    bool m_isMenuPress = false;              ///< the right button is down on a part
};

} // namespace quadrille::widgets
