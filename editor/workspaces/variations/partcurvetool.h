// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/context/settings.h"
#include "editor/jobs/job.h"
#include "editor/workspaces/variations/partcut.h"
#include "model/geometry/surfacecurve.h"
#include "model/geometry/symmetry.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/tools/surfacecurveeditor.h"

#include <QObject>
#include <QPointer>
#include <functional>
#include <map>

class QAction;

namespace quadrille {

class BodySurface;
class CurrentVariation;

/// A curve or a part, by name.
struct PartSelection
{
    enum class Kind
    {
        None,
        Curve,
        Part
    };
    Kind kind = Kind::None;
    std::string name;

    bool operator==(const PartSelection&) const = default;
};

/// What there is to say about the last thing that was asked for.
struct PartNotice
{
    widgets::MessageStrip::Kind kind = widgets::MessageStrip::Kind::Info;
    QString sentence;
    QString remedy;
};

/// Joins the curves and parts of the character's body with the view: what is clicked and dragged there leads
/// the model's curves and becomes edits that can be undone; the parts that come of it colour the body at
/// once.
class PartCurveTool : public QObject
{
    Q_OBJECT

public:
    using Edit = std::function<void(BodyPartsEntry&)>;

    explicit PartCurveTool(CurrentVariation& variation, QObject* parent = nullptr);
    ~PartCurveTool() override;

    CurrentVariation& variation() const { return m_variation; }
    widgets::SurfaceCurveEditor& editor() const { return *m_editor; }
    BodySurface& surface() const { return *m_surface; }
    /// As the project has it.
    const BodyPartsEntry& body() const { return m_body; }
    const PartCut& cut() const { return m_cut; }
    const PartSelection& selected() const { return m_selected; }
    void select(const PartSelection& selection);
    /// Whether a job changes curves or parts right now.
    bool isBusy() const { return m_job != nullptr; }
    /// Shows curves and colours in the view, and takes its clicks; so does "variations.parts.show".
    void setActive(bool active);

    bool snaps() const { return m_drawing.snaps; }
    void setSnaps(bool snaps);
    /// How far a point jumps to a crease, metres.
    double snapRadius() const { return m_drawing.snapRadius; }
    void setSnapRadius(double metres);
    /// Between the two curves of a part, metres over the surface.
    double overlap() const { return m_drawing.overlap; }
    void setOverlap(double metres);

    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    void propose();
    void draw();
    /// A part from the selected curve and the one beside it, or from one curve and a second that is made.
    void addPart();
    void addSecondCurve();
    /// The selected curve, or part, to the other side.
    void mirror();
    void shorten();
    void removeSelected();
    /// \return whether the name was free.
    bool rename(const PartSelection& which, const QString& name);
    /// Curves are drawn in the pose that is shown from now on.
    void takeShownPose();

    /// Curves that bound no part.
    std::vector<std::string> looseCurves() const;
    /// Length, metres; 0 while the surface is not there.
    double lengthOfCurve(const std::string& name) const;
    /// In the user's words.
    static QString sentence(const Error& error);

signals:
    /// Curves, parts, the surface or what is busy are others.
    void changed();
    void selectionChanged();
    /// Something could not be done, or had consequences; an empty sentence takes the last one back.
    void told(const quadrille::PartNotice& notice);
    /// "variations.parts.show" was switched.
    void visibilityRequested();
    /// What is done now is to be seen: the panel is to come to the front.
    void panelRequested();

private:
    struct Route; ///< a curve while its points are edited
    void makeActions();
    void connectEditor();
    void keepDrawing();
    void refresh();
    void refreshFigure();
    void frameFigure();
    void refreshCurves();
    void refreshColors();
    void refreshActions();
    void followSelection();
    void describeSelection();
    void showMenu(const widgets::SurfaceCurvePart& part, const QPoint& globalPosition);
    QAction* addAction(const char* id, std::function<QString()> text, std::function<QString()> tip,
                       const char* icon, const QKeySequence& shortcut, std::function<void()> run);

    const PartCurveEntry* curveAt(int index) const;
    int indexOf(const std::string& curve) const;
    const PartCurveEntry* selectedCurve() const;
    widgets::ShownCurve shown(const PartCurveEntry& entry) const;
    /// Where a point goes; to a crease where that is wanted and free.
    VertexIndex vertexAt(const widgets::SurfacePlace& place, const Route& route) const;
    std::vector<VertexIndex> obstaclesFor(const std::string& curve) const;
    /// A curve ready for edits. \pre There is a surface.
    std::unique_ptr<Route> routeOf(const PartCurveEntry* entry, bool snaps) const;
    void addPoint(const widgets::SurfacePlace& place);
    void removeLastPoint();
    void preview(const std::optional<widgets::SurfacePlace>& place);
    void movePoint(int curve, int point, const widgets::SurfacePlace& place, bool committed);
    void cancelMove(int curve);
    void insertPoint(int curve, int after, const widgets::SurfacePlace& place);
    void removePoint(int curve, int point);
    void take(const Route& route, const QString& text, const QString& property,
              EditPhase phase = EditPhase::Final);
    void finishDrawing();
    void refuse(const Error& error);
    /// Works on a copy of the body in a job; what it returns becomes one edit.
    void run(const QString& name, const QString& text,
             std::function<BodyPartsEntry(BodyPartsEntry, const Progress&)> work,
             const PartSelection& selectAfterwards = {});

    CurrentVariation& m_variation;
    BodySurface* m_surface;
    widgets::SurfaceCurveEditor* m_editor;
    BodyPartsEntry m_body;
    PartCut m_cut;
    PartSelection m_selected;
    std::string m_drawn; ///< the curve that is drawn; empty before its first point
    std::unique_ptr<Route> m_drag;
    std::unique_ptr<Route> m_trial; ///< the drawn curve with a point at the pointer
    std::map<std::string, std::pair<PartCurveEntry, widgets::ShownCurve>> m_shown;
    std::shared_ptr<const SurfaceGraph> m_shownGraph; ///< that m_shown was made on
    QPointer<Job> m_job;
    std::shared_ptr<const Symmetry> m_symmetry; ///< of m_shownGraph, once it was asked for
    bool m_isActive = false;
    int m_framed = -1; ///< the figure that the view came close to
    Settings::CurveDrawing m_drawing;
};

} // namespace quadrille
