// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/workspaces/variations/partcurvecontent.h"
#include "widgets/tools/surfacecurveeditor.h"

#include <map>

namespace quadrille {

class SceneView;

/// Shows the curves and parts of a body in a view: finds the figure that they are on, and gives it their
/// colours.
class PartCurveView
{
public:
    /// \param content  outlives it, as do `view` and `editor`.
    PartCurveView(const PartCurveContent& content, SceneView& view, widgets::SurfaceCurveEditor& editor)
        : m_content(content), m_view(view), m_editor(editor)
    {
    }
    /// Whether anything is shown; the view's clicks go to the editor then. What shows is refreshed by the
    /// caller.
    void setActive(bool active);
    bool isActive() const { return m_isActive; }

    /// The surface is another now.
    void forgetSurface() { m_shown.clear(); }
    /// It is the first clip that has as many vertices and triangles as the surface; none where no clip has.
    void refreshFigure();
    /// The body instead of all its way, the first time that its parts are worked on.
    void frameFigure();
    /// Gives the editor all curves of the content; those that stayed as they were are not led anew.
    /// \param drawn  the curve that is drawn, by name.
    void refreshCurves(const std::string& drawn);
    void refreshColors();
    /// Says what is selected to those who cannot see the handles.
    void describeSelection();

private:
    const PartCurveContent& m_content;
    SceneView& m_view;
    widgets::SurfaceCurveEditor& m_editor;
    std::map<std::string, std::pair<PartCurveEntry, widgets::ShownCurve>> m_shown;
    bool m_isActive = false;
    int m_framed = -1; ///< the figure that the view came close to
};

/// A curve as an editor shows it, without colour and problem. One that is not whole is shown as far as it
/// goes, and is not closed. \param graph  may be null: nothing of it is shown.
widgets::ShownCurve shownCurve(const std::shared_ptr<const SurfaceGraph>& graph, const PartCurveEntry& entry);

} // namespace quadrille
