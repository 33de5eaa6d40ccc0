// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathresult.h"

#include "editor/application/editorcontext.h"
#include "editor/documents/animationresult.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathentries.h"
#include "editor/workspaces/view/stageview.h"
#include "model/synthesis/pathfollowing.h"
#include "widgets/theme/theme.h"

#include <QAction>
#include <QLocale>
#include <algorithm>

namespace quadrille {

using widgets::ColorRole;
using widgets::SceneCurve;
using widgets::SceneMarks;
using widgets::Theme;

namespace {

constexpr float wayWidth = 3.5F;    // pixels
constexpr float dashLength = 0.06F; // metres
constexpr std::size_t mostLines = 120;
const auto layer = QStringLiteral("result");

} // namespace

PathResult::PathResult(CurrentAnimation& animation, QObject* parent) : QObject(parent), m_animation(animation)
{
    ActionRegistry& actions = animation.context().actions;
    actions.addToggle({"animate.path.deviation",
                       [] { return tr("Animate"); },
                       [] { return tr("Show the &deviation"); },
                       [] { return tr("Draw a line from the body’s centre to where the path wants it"); },
                       "measure",
                       {}},
                      m_isDeviationShown, [this](bool shown) { setDeviationShown(shown); });
    connect(&animation, &CurrentAnimation::resultChanged, this, &PathResult::refresh);
    connect(&animation.view().viewport(), &widgets::Viewport::groundHeightChanged, this,
            &PathResult::refresh);
    connect(&Theme::instance(), &Theme::changed, this, &PathResult::refresh);
    connect(actions.action(QStringLiteral("view.trajectory")), &QAction::toggled, this, &PathResult::refresh);
    refresh();
}

void PathResult::setDeviationShown(bool shown)
{
    m_isDeviationShown = shown;
    refresh();
}

void PathResult::refresh()
{
    const auto result = m_animation.result();
    const bool isShown = m_animation.context().actions.action(QStringLiteral("view.trajectory"))->isChecked();
    const bool isThere = result && isShown && m_animation.entry() != nullptr;
    m_animation.view().viewport().setMarks(layer, isThere ? marks(*result) : SceneMarks());
}

SceneMarks PathResult::marks(const AnimationResult& result) const
{
    SceneMarks marks;
    addWay(result, marks);
    if (m_isDeviationShown && result.walk.constraints.path && result.walk.constraints.path->points.size() > 1)
        addDeviation(result, marks);
    return marks;
}

void PathResult::addWay(const AnimationResult& result, SceneMarks& marks) const
{
    const PathSpace space{.up = result.plan.up, .ground = m_animation.view().viewport().groundHeight()};
    const PathEntry* path = findPath(result.entry);
    const bool onGround = path == nullptr || !path->inSpace;
    bool wasCaptured = false;
    for (const PlannedFrame& frame : result.plan.frames) {
        const bool isCaptured = frame.isCaptured();
        const QVector3D place = space.toView(frame.centre, onGround);
        if (marks.curves.empty() || isCaptured != wasCaptured) {
            SceneCurve part{.points = {},
                            .color = Theme::color(isCaptured ? ColorRole::Original : ColorRole::Synthetic),
                            .colors = {},
                            .width = wayWidth,
                            .dash = isCaptured ? 0.0F : dashLength};
            if (!marks.curves.empty())
                part.points.push_back(marks.curves.back().points.back());
            marks.curves.push_back(std::move(part));
            wasCaptured = isCaptured;
        }
        marks.curves.back().points.push_back(place);
    }
}

void PathResult::addDeviation(const AnimationResult& result, SceneMarks& marks) const
{
    const PathSpace space{.up = result.plan.up, .ground = m_animation.view().viewport().groundHeight()};
    const bool onGround = !result.walk.constraints.path->inSpace;
    const auto frames = followPath(*result.walk.constraints.path, result.plan);
    SceneCurve lines{.points = {}, .color = Theme::color(ColorRole::Line), .colors = {}, .width = 1.0F};
    lines.color.setAlphaF(0.6F); // many lie side by side
    lines.pairs = true;
    const std::size_t step = frames.size() / mostLines + 1;
    for (std::size_t i = 0; i < frames.size(); i += step) {
        lines.points.push_back(space.toView(frames[i].centre, onGround));
        lines.points.push_back(space.toView(frames[i].wanted, onGround));
    }
    marks.curves.push_back(std::move(lines));
    const auto worst = std::max_element(frames.begin(), frames.end(), [](const auto& a, const auto& b) {
        return a.deviation() < b.deviation();
    });
    if (worst == frames.end())
        return;
    const double centimetres =
        worst->deviation() * 100 * m_animation.context().document.project().settings.axes.metresPerUnit;
    marks.labels.push_back({space.toView(worst->centre, onGround),
                            tr("%1 cm away").arg(QLocale().toString(centimetres, 'f', 1)), QColor()});
}

} // namespace quadrille
