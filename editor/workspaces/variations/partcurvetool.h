// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/workspaces/variations/partcurvecontent.h"
#include "widgets/controls/messagestrip.h"
#include "widgets/tools/surfacecurveeditor.h"

#include <QObject>
#include <functional>
#include <memory>

namespace quadrille {

class BodySurface;
class CurrentVariation;
class PartCurveActions;
class PartCurveGestures;
class PartCurveJobs;
class PartCurveView;

/// What there is to say about the last thing that was asked for.
struct PartNotice
{
    widgets::MessageStrip::Kind kind = widgets::MessageStrip::Kind::Info;
    QString sentence;
    QString remedy;
};

/// Joins the curves and parts of the character's body with the view: what is clicked and dragged there
/// (PartCurveGestures), and what jobs compute (PartCurveJobs), becomes edits that can be undone; what comes
/// of them is shown at once (PartCurveView).
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
    const BodyPartsEntry& body() const { return m_content.body; }
    const PartCut& cut() const { return m_content.cut; }
    const PartSelection& selected() const { return m_content.selected; }
    /// A curve is selected in the view as well.
    void select(const PartSelection& selection);
    /// Whether a job changes curves or parts right now.
    bool isBusy() const;
    /// Shows curves and colours in the view, and takes its clicks; so does "variations.parts.show".
    void setActive(bool active);

    bool snaps() const { return m_content.drawing.snaps; }
    /// Kept in the settings; so for the next two setters.
    void setSnaps(bool snaps);
    /// How far a point jumps to a crease, metres.
    double snapRadius() const { return m_content.drawing.snapRadius; }
    void setSnapRadius(double metres);
    /// Between the two curves of a part, metres over the surface.
    double overlap() const { return m_content.drawing.overlap; }
    void setOverlap(double metres);

    void edit(const QString& text, const QString& property, const Edit& edit,
              EditPhase phase = EditPhase::Final);
    /// Proposes parts in a job: all curves and parts give way to them. Nothing happens before there is a
    /// surface.
    void propose();
    /// Brings workspace and panel to the front, and begins or ends drawing a curve in the view.
    void draw();
    /// A part from the selected curve and the one beside it, or from one curve and a second that is made.
    void addPart();
    void addSecondCurve();
    /// The selected curve, or part, to the other side.
    void mirror();
    /// Leads the selected curve to where the limb is thinnest nearby.
    void shorten();
    /// Nothing happens where nothing is selected. That a part lacks a curve then is told.
    void removeSelected();
    /// \return whether the name was free. \param name  the one that it has already counts as free. `told`
    /// says so where it is taken.
    bool rename(const PartSelection& which, const QString& name);
    /// Curves are drawn in the pose that is shown from now on.
    void takeShownPose();

    /// Curves that bound no part.
    std::vector<std::string> looseCurves() const { return m_content.looseCurves(); }
    /// Length, metres; 0 while the surface is not there.
    double lengthOfCurve(const std::string& name) const { return m_content.lengthOfCurve(name); }
    /// In the user's words. What to do about it is left out.
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
    void connectParts();
    void keepDrawing();
    void refresh();
    void followMode(widgets::SurfaceCurveEditor::Mode mode);
    void followSelection();
    /// What becomes of the body, and what is selected then; none: as it was.
    void take(const QString& text, const BodyPartsEntry& body, const PartSelection& selection);

    CurrentVariation& m_variation;
    BodySurface* m_surface;
    widgets::SurfaceCurveEditor* m_editor;
    PartCurveContent m_content;
    PartCurveGestures* m_gestures;
    PartCurveJobs* m_jobs;
    std::unique_ptr<PartCurveView> m_view;
    std::unique_ptr<PartCurveActions> m_actions;
};

} // namespace quadrille
