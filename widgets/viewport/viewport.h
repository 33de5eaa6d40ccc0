// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/theme/colormap.h"
#include "widgets/viewport/figureshape.h"
#include "widgets/viewport/groundshadow.h"
#include "widgets/viewport/ruler.h"
#include "widgets/viewport/scenemarks.h"
#include "widgets/viewport/shading.h"
#include "widgets/viewport/turntable.h"
#include "widgets/viewport/viewgestures.h"

#include <QColor>
#include <QImage>
#include <QVector3D>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace quadrille::widgets {

class ViewTool;
class VtkView;

/// A translucent earlier or later pose. The colour's alpha is its opacity; opaque means the usual one.
struct Ghost
{
    std::vector<float> positions; ///< vertices × 3
    QColor color;
    QString label; ///< above its head, beside its colour; may be empty
};

/// Where the pointer met a figure.
struct Pick
{
    int figure = 0;
    std::uint32_t triangle = 0;
    std::uint32_t vertex = 0; ///< the triangle's corner next to the point
    std::array<float, 3> barycentric{};
    QVector3D point; ///< in the view: with the figure's offset
};

struct SnapshotOptions
{
    QSize size;              ///< pixels; empty: as on the screen
    bool background = true;  ///< else transparent, without ground
    bool annotations = true; ///< legend, measurement, names
};

/// Shows figures in three dimensions and lets them be looked at from everywhere; lengths are in the unit of
/// its ruler. Where there is no OpenGL, a label says so and everything else still works.
class Viewport : public QWidget
{
    Q_OBJECT
public:
    enum class Layout
    {
        Overlay,
        SideBySide ///< several stand in lanes of their own; one alone stands where it is
    };
    enum class Tool
    {
        Navigate,
        Measure ///< two clicks on surfaces
    };

    explicit Viewport(QWidget* parent = nullptr);
    ~Viewport() override;

    /// Something plays: pictures are drawn as well as there is time for until it does no longer.
    void setMoving(bool moving);
    /// Whether pictures are shown; false without OpenGL.
    bool isWorking() const;

    /// \return an id for the calls below. The figure is at the origin until it gets positions.
    int addFigure(FigureMesh mesh, const QString& name = {});
    void removeFigure(int figure);
    void setFigureName(int figure, const QString& name);
    void clear(); ///< marks stay
    std::vector<int> figures() const;
    /// None where there is no such figure.
    std::optional<FigureShape> figureShape(int figure) const;
    /// A new frame; quick enough for playback (under 1 ms at 20,000 vertices).
    /// \param positions  vertices × 3, in the order of the mesh.
    void setPositions(int figure, std::span<const float> positions);
    /// A null image takes the texture away; the figure is then clay. RGB888 and RGBA8888 are the quickest.
    void setTexture(int figure, const QImage& texture, int material = 0);
    /// Of clay; an invalid colour means the theme's.
    void setFigureColor(int figure, const QColor& color);
    void setFigureOffset(int figure, const QVector3D& offset); ///< besides that of its lane
    void setFigureVisible(int figure, bool visible);
    /// The box that a figure stays in over all its frames, in its own coordinates: the lane that it needs,
    /// and what framing shows unless the camera goes along with the figure.
    void setFigureExtent(int figure, const QVector3D& lower, const QVector3D& upper);
    /// The order of lanes where several stand side by side; that in which they came by default.
    void setFigureOrder(const std::vector<int>& figures);
    /// The figure that stays in its place where several stand side by side, as marks do; else the first.
    void setAnchor(int figure);
    void setFigureOpacity(int figure, double opacity);
    /// One value per vertex or triangle; empty takes them away. Shown in Shading::Scalar with a legend.
    void setScalars(int figure, std::span<const float> values, ScalarPlace place, const ScalarRange& range);
    /// A colour for each triangle in place of scalars, shown as they are with its own legend. Empty: none.
    void setTriangleColors(int figure, std::span<const QRgb> colors, const ColorKey& key);
    void setGhosts(int figure, const std::vector<Ghost>& ghosts);
    /// A line on the ground, e.g. of the centroid; in the figure's coordinates.
    void setTrajectory(int figure, const std::vector<QVector3D>& points, const QColor& color = {});
    /// Curves, areas and words beside the figures, under a name of the caller's; empty ones go away.
    void setMarks(const QString& layer, const SceneMarks& marks);

    void setShading(Shading shading);
    Shading shading() const;
    void setLayoutMode(Layout layout);
    Layout layoutMode() const;
    void setGridVisible(bool visible);
    bool isGridVisible() const;
    /// Who makes the shadows of figures on the ground; without anybody there are none.
    void setShadowMaker(ShadowMaker maker);
    void setShadowsVisible(bool visible);
    bool areShadowsVisible() const;
    void setGhostsVisible(bool visible);
    void setTrajectoriesVisible(bool visible);
    /// Names above the figures; useful where there are several.
    void setNamesVisible(bool visible);
    /// A sentence in the middle of the view, for as long as there is nothing to look at; empty for none.
    void setNotice(const QString& text);
    const QString& notice() const;
    void setUpAxis(UpAxis axis);
    /// What coordinates are in; metres by default. The camera keeps what it sees.
    void setRuler(const Ruler& ruler);
    const Ruler& ruler() const;
    void setGroundHeight(float height); ///< along the up axis
    float groundHeight() const;
    /// The camera moves along with a figure; no figure: it stays.
    void setFollowed(std::optional<int> figure);
    std::optional<int> followed() const;
    void setTool(Tool tool);
    Tool tool() const;
    void clearMeasurement();
    /// Gets the events of the view first, unless there is measured; null for nothing. The caller keeps it.
    void setViewTool(ViewTool* tool);
    ViewTool* viewTool() const;

    void setMousePreset(MousePreset preset);
    MousePreset mousePreset() const;
    Turntable camera() const;                ///< where a movement under way ends
    void setCamera(const Turntable& camera); ///< at once
    /// Moves the camera so that one figure, or all that are visible, fill the view, with the curves that are
    /// drawn about them. Those belong to the figure that stands in its place.
    void frameFigure(int figure);
    void frameAll();
    void lookFrom(StandardView view);

    /// Where a pixel of this widget shows a figure.
    std::optional<Pick> pick(const QPointF& position) const;
    /// Null when nothing can be drawn yet.
    QImage snapshot(const SnapshotOptions& options = {});
    VtkView* view() const; ///< null without OpenGL

    QSize sizeHint() const override { return {960, 640}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    /// A click on a figure.
    void picked(const quadrille::widgets::Pick& pick, Qt::MouseButton button,
                Qt::KeyboardModifiers modifiers);
    /// A click on nothing.
    void missed(Qt::MouseButton button);
    /// The pointer is over a figure, or over none any more.
    void hovered(const std::optional<quadrille::widgets::Pick>& pick);
    void measured(double length); ///< between two clicks with Tool::Measure, metres
    /// A figure has other positions.
    void figureChanged(int figure);
    void toolChanged(quadrille::widgets::Viewport::Tool tool);
    void cameraChanged();
    void groundHeightChanged(float height);
    /// A click with the right button, or the key for menus. Drags with that button move the camera.
    void contextMenuRequested(const QPoint& globalPosition);
    /// A picture was drawn. \param milliseconds  what drawing took.
    void rendered(double milliseconds);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Private;
    std::unique_ptr<Private> d;
    void click(const QPointF& position, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);
    void arrange();
    void redraw();
};

} // namespace quadrille::widgets
