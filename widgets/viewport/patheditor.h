// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/handletool.h"
#include "widgets/viewport/pathshape.h"

#include <QPointF>
#include <memory>
#include <optional>

class QKeyEvent;
class QMouseEvent;

namespace quadrille::widgets {

class SampledCurve;
class Viewport;

/// Something of a path that can be taken hold of.
struct PathPart
{
    enum class Kind
    {
        None,
        Point, ///< or handle, by its index among all points
        StretchStart,
        StretchEnd,
        Obstacle,       ///< its middle
        ObstacleCorner, ///< of a polygon
        ObstacleRadius, ///< the edge of a disc
        Lift,           ///< the arrow that moves a point in space up and down
        Curve
    };
    Kind kind = Kind::None;
    int index = 0;
    int corner = 0; ///< of an obstacle

    bool operator==(const PathPart&) const = default;
};

/// What is done to the points of a path.
enum class PathEdit
{
    Add,
    Move,
    Insert,
    Delete,
    Draw ///< a stroke by a free hand
};

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
    enum class Mode
    {
        Edit,
        Draw,
        Disc,   ///< drag from its middle
        Polygon ///< corner by corner
    };

    /// \param viewport  what it draws into; it is to be made the viewport's tool by setViewTool().
    explicit PathEditor(Viewport& viewport, QObject* parent = nullptr);
    ~PathEditor() override;

    /// Makes the curve of points, also of those that are not yet there. \pre set before any shape.
    void setSampler(PathSampler sampler);
    void setShape(const PathShape& shape);
    const PathShape& shape() const;
    const SampledCurve& curve() const;
    /// Shows nothing and uses no events while false.
    void setActive(bool active);
    bool isActive() const;
    void setMode(Mode mode);
    Mode mode() const;
    void setSelected(const PathPart& part);
    const PathPart& selected() const;
    /// The height above the ground that the first point gets in space.
    void setUsualHeight(float height);
    /// Whether something is being dragged.
    bool isDragging() const override;
    bool isDrawing() const override;
    /// Where a part is on the view; none when it is not to be seen or not there.
    std::optional<QPointF> pixelOf(const PathPart& part) const;
    /// The part that would be dragged from here.
    PathPart partAt(const QPointF& position) const;

    /// What double click and Delete do, for menus. \param length  along the curve.
    void insertPoint(double length);
    void removeSelected();
    /// Puts the handles of the selected point of a Bézier path onto one line.
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
    void addPoint(const QVector3D& place);
    void insertOnCurve(std::size_t anchor, float t, const QVector3D& place);
    bool nudge(int key, Qt::KeyboardModifiers modifiers);
    bool resizeSelected(float by);
    double shortestStretch() const;
    float smallestRadius() const;
    bool deleteSelected();
    void askMenu(const PathPart& part, const QPointF& position, const QPoint& globalPosition);
    void dragTo(const QMouseEvent& event);
    void applyTo(const PathPart& part, const QVector3D& place, bool mirrored, bool committed);
    void finishStroke(bool commit);
    void finishObstacle();
    bool finishMode();
    void refreshMarks();
};

} // namespace quadrille::widgets
