// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "widgets/viewport/figureactor.h"
#include "widgets/viewport/ghostactor.h"
#include "widgets/viewport/ruler.h"
#include "widgets/viewport/scenemarks.h"
#include "widgets/viewport/sceneshadows.h"
#include "widgets/viewport/turntable.h"

#include <QImage>
#include <QVector3D>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkRenderWindow;

namespace quadrille::widgets {

class GroundGrid;
struct Ghost;

/// What a viewport knows of one figure.
struct SceneFigure
{
    std::unique_ptr<FigureActor> actor;
    std::vector<std::unique_ptr<GhostActor>> ghosts;
    std::vector<SceneLabel> ghostLabels; ///< in the figure's coordinates
    QString name;
    QVector3D offset;       ///< asked for
    QVector3D layoutOffset; ///< from standing side by side
    QColor color;           ///< of clay; invalid: the theme's
    bool visible = true;
    double opacity = 1.0;
    std::optional<std::pair<QVector3D, QVector3D>> firstPose; ///< lower and upper corner of the first pose
    std::optional<std::pair<QVector3D, QVector3D>> extent;    ///< the same over all frames
    ScalarRange scalarRange;
    std::optional<ColorKey> colorKey; ///< of triangle colours that take the place of scalars

    QVector3D shift() const { return offset + layoutOffset; }
};

/// The VTK side of a viewport: renderer, lights, background, ground, figures, trajectories.
class ViewportScene
{
public:
    ViewportScene();
    ~ViewportScene();
    ViewportScene(const ViewportScene&) = delete;
    ViewportScene& operator=(const ViewportScene&) = delete;

    void attachTo(vtkRenderWindow* window);
    void setCamera(const Turntable& camera);
    /// Takes colours from the theme.
    void updateColors();
    void setShading(Shading shading);
    Shading shading() const;
    GroundGrid& ground();
    SceneShadows& shadows();
    /// What the coordinates of everything are in.
    void setRuler(const Ruler& ruler);
    const Ruler& ruler() const;
    /// Height of the ground along the up axis.
    void setGroundHeight(float height);
    /// \param pixels  of the screen for one logical pixel: lines are as wide everywhere.
    void setPixelRatio(double pixels);

    std::map<int, SceneFigure>& figures() { return m_figures; }
    const std::map<int, SceneFigure>& figures() const { return m_figures; }
    SceneFigure& add(int id, FigureMesh mesh, const QString& name);
    void remove(int id);
    /// Puts offsets, colours, visibility onto the actors.
    void refresh(SceneFigure& figure);
    void setGhosts(SceneFigure& figure, const std::vector<Ghost>& ghosts);
    void setGhostsVisible(bool visible);
    /// \param points  in the figure's coordinates; empty takes the line away.
    void setTrajectory(int id, const std::vector<QVector3D>& points, const QColor& color);
    void setTrajectoriesVisible(bool visible);
    void setMarks(const QString& layer, const SceneMarks& marks);
    /// The box that all curves lie in; none without any.
    std::optional<std::pair<QVector3D, QVector3D>> markBounds() const;
    /// Those of all layers, until the next change.
    std::vector<const SceneMarks*> marks() const;

    /// Draws once at a size and reads it back. \pre the window's context is current.
    /// \param ratio  pixels of the picture for one logical pixel.
    QImage draw(vtkRenderWindow* window, const QSize& size, double ratio, bool background);

private:
    struct Private;
    std::unique_ptr<Private> d;
    std::map<int, SceneFigure> m_figures;
    void prepare();
    void sortGhosts(const Turntable& camera);
    void applyTrajectory(int id);
};

} // namespace quadrille::widgets
