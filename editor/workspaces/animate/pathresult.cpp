// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathresult.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/framekinds.h"
#include "editor/workspaces/animate/pathentries.h"
#include "editor/workspaces/view/sceneview.h"
#include "model/project/results/openanimation.h"
#include "model/synthesis/walks/pathfollowing.h"
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
constexpr float ringRadius = 0.08F; // metres
constexpr std::size_t mostLines = 120;
const auto layer = QStringLiteral("result");

QString centimetresOf(double metres)
{
    return QLocale().toString(metres * 100, 'f', 1);
}

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
    connect(&animation.view().scene(), &ClipScene::frameShown, this, &PathResult::showFrame);
    connect(&animation.view().player(), &Player::playingChanged, this, &PathResult::showFrame);
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
    m_followed.clear();
    m_worst.reset();
    if (isThere && result->walk.constraints.path && result->walk.constraints.path->points.size() > 1)
        m_followed = followPath(*result->walk.constraints.path, result->plan,
                                result->character->graph.metresPerUnit());
    if (m_isDeviationShown && !m_followed.empty())
        m_worst = worstLabel(*result);
    m_animation.view().viewport().setMarks(layer, isThere ? marks(*result) : SceneMarks());
    showFrame();
}

/// Where the path wants the body in the frame that is shown.
void PathResult::showFrame()
{
    const auto result = m_animation.result();
    const auto frame = static_cast<std::size_t>(m_animation.view().scene().frame().value);
    SceneMarks marks;
    // Clips that were cut, repeated or retimed have other frames than the walk.
    if (m_isDeviationShown && result && frame < m_followed.size() &&
        result->sequence.frameCount() == static_cast<std::int64_t>(m_followed.size())) {
        const PathSpace space{.up = result->plan.up, .ground = m_animation.view().viewport().groundHeight()};
        const bool onGround = !result->walk.constraints.path->inSpace;
        const QVector3D wanted = space.toView(m_followed[frame].wanted, onGround);
        const QVector3D up = space.up == UpAxis::Z ? QVector3D(0, 0, 1) : QVector3D(0, 1, 0);
        std::vector<QVector3D> ring =
            widgets::circleOnGround(wanted, m_animation.view().viewport().ruler().of(ringRadius), up);
        ring.push_back(ring.front());
        const QColor color = Theme::color(ColorRole::AccentText);
        marks.curves = {{.points = std::move(ring), .color = color, .colors = {}, .width = 2.0F},
                        {.points = {space.toView(m_followed[frame].centre, onGround), wanted},
                         .color = color,
                         .colors = {},
                         .width = 2.0F}};
        if (!m_animation.view().player().isPlaying())
            marks.labels.push_back({.place = wanted,
                                    .text = tr("%1 cm").arg(centimetresOf(m_followed[frame].deviation)),
                                    .color = QColor(),
                                    .beside = true});
    }
    if (m_worst && !m_animation.view().player().isPlaying())
        marks.labels.push_back(*m_worst);
    if (!marks.isEmpty() || m_isFrameMarked)
        m_animation.view().viewport().setMarks(QStringLiteral("frame"), marks);
    m_isFrameMarked = !marks.isEmpty();
}

SceneMarks PathResult::marks(const AnimationResult& result) const
{
    SceneMarks marks;
    addWay(result, marks);
    if (m_isDeviationShown && !m_followed.empty())
        addDeviation(result, marks);
    return marks;
}

void PathResult::addWay(const AnimationResult& result, SceneMarks& marks) const
{
    const PathSpace space{.up = result.plan.up, .ground = m_animation.view().viewport().groundHeight()};
    const PathEntry* path = findPath(result.entry);
    const bool onGround = path == nullptr || !path->inSpace;
    const float dash = m_animation.view().viewport().ruler().of(dashLength);
    auto before = widgets::FrameKind::Captured;
    for (const PlannedFrame& frame : result.plan.frames) {
        const widgets::FrameKind kind = frameKindOf(frame.origin);
        const QVector3D place = space.toView(frame.centre, onGround);
        if (marks.curves.empty() || kind != before) {
            SceneCurve part{.points = {},
                            .color = widgets::frameKindColor(kind),
                            .colors = {},
                            .width = wayWidth,
                            .dash = kind == widgets::FrameKind::Captured ? 0.0F : dash};
            if (!marks.curves.empty())
                part.points.push_back(marks.curves.back().points.back());
            marks.curves.push_back(std::move(part));
            before = kind;
        }
        marks.curves.back().points.push_back(place);
    }
}

void PathResult::addDeviation(const AnimationResult& result, SceneMarks& marks) const
{
    const PathSpace space{.up = result.plan.up, .ground = m_animation.view().viewport().groundHeight()};
    const bool onGround = !result.walk.constraints.path->inSpace;
    const auto& frames = m_followed;
    SceneCurve lines{.points = {}, .color = Theme::color(ColorRole::Line), .colors = {}, .width = 1.0F};
    lines.color.setAlphaF(0.6F); // many lie side by side
    lines.pairs = true;
    const std::size_t step = frames.size() / mostLines + 1;
    for (std::size_t i = 0; i < frames.size(); i += step) {
        lines.points.push_back(space.toView(frames[i].centre, onGround));
        lines.points.push_back(space.toView(frames[i].wanted, onGround));
    }
    marks.curves.push_back(std::move(lines));
}

widgets::SceneLabel PathResult::worstLabel(const AnimationResult& result) const
{
    const PathSpace space{.up = result.plan.up, .ground = m_animation.view().viewport().groundHeight()};
    const bool onGround = !result.walk.constraints.path->inSpace;
    const auto worst = std::ranges::max_element(m_followed, {}, &FollowedFrame::deviation);
    return {.place = space.toView(worst->centre, onGround),
            .text = tr("%1 cm away").arg(centimetresOf(worst->deviation)),
            .color = QColor(),
            .beside = true};
}

} // namespace quadrille

#include "moc_pathresult.cpp"
