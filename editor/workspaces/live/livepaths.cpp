// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/live/livepaths.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/live/livesession.h"
#include "model/core/error.h"
#include "model/live/livepath.h"
#include "model/project/document/findentry.h"
#include "model/project/steps/pathrequest.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/viewport.h"

#include <algorithm>

namespace quadrille {

using widgets::ColorRole;
using widgets::SceneArea;
using widgets::SceneCurve;
using widgets::SceneMarks;
using widgets::Theme;

namespace {

/// Points of a route as they are drawn, in the project's unit.
class DrawnGround
{
public:
    DrawnGround(const CoordinateSystem& axes, double height)
        : m_ground(axes.up), m_unit(axes.metresPerUnit), m_height(height)
    {
    }

    QVector3D operator()(const Vec2d& metres) const
    {
        const Vec3f point = m_ground.at(metres / m_unit, m_height).cast<float>();
        return {point.x(), point.y(), point.z()};
    }
    QVector3D up() const
    {
        const Vec3f up = m_ground.up().cast<float>();
        return {up.x(), up.y(), up.z()};
    }

private:
    Ground m_ground;
    double m_unit;
    double m_height; ///< in the same unit
};

} // namespace

LivePaths::LivePaths(EditorContext& context, LiveSession& session, widgets::Viewport& viewport,
                     QObject* parent)
    : QObject(parent), m_context(context), m_session(session), m_viewport(viewport)
{
    connect(&session, &LiveSession::changed, this, &LivePaths::followSession);
    connect(&context.document, &ProjectDocument::changed, this, &LivePaths::changed);
    connect(&context.document, &ProjectDocument::renamed, this, [this](const ChangeEvent& event) {
        if (event.entry.section == Section::Animations && event.before == m_chosen)
            m_chosen = event.entry.name;
        emit changed();
    });
    connect(&Theme::instance(), &Theme::changed, this, &LivePaths::showPath);
}

const PathEntry* LivePaths::pathOf(const QString& animation) const
{
    const AnimationEntry* entry = findAnimation(m_context.document.project(), animation.toStdString());
    if (entry == nullptr)
        return nullptr;
    for (const ConstraintEntry& constraint : entry->constraints) {
        if (const auto* path = std::get_if<PathEntry>(&constraint))
            return path;
    }
    return nullptr;
}

QStringList LivePaths::names() const
{
    QStringList names;
    for (const AnimationEntry& entry : m_context.document.project().animations) {
        QString name = QString::fromStdString(entry.name);
        if (pathOf(name) != nullptr)
            names += std::move(name);
    }
    return names;
}

void LivePaths::choose(const QString& animation)
{
    const PathEntry* path = pathOf(animation);
    if (path == nullptr) {
        m_session.followPath(std::nullopt);
        return;
    }
    // Keeping a recording changes the project.
    const PathConstraint wanted = pathInMetres(*path, m_context.document.project().settings.axes);
    emit beginning();
    try {
        m_session.followPath(wanted);
        m_chosen = animation;
    } catch (const Error& error) {
        emit failed(error);
    }
    showPath();
    emit changed();
}

/// It ends where somebody steers, or something else is played.
void LivePaths::followSession()
{
    if (m_chosen.isEmpty() || m_session.follower() != nullptr)
        return;
    m_chosen.clear();
    showPath();
    emit changed();
}

void LivePaths::showPath()
{
    SceneMarks marks;
    const LivePathFollower* follower = m_session.follower();
    if (!m_chosen.isEmpty() && follower != nullptr) {
        const CoordinateSystem& axes = m_context.document.project().settings.axes;
        const DrawnGround drawn(axes, static_cast<double>(m_viewport.groundHeight()));
        const PathCourse& route = follower->route();
        constexpr double step = 0.05; // metres
        SceneCurve curve{.color = Theme::color(ColorRole::Accent)};
        for (double walked = 0; walked < route.length() + step; walked += step)
            curve.points.push_back(drawn(route.at(std::min(walked, route.length())).head<2>()));
        marks.curves.push_back(std::move(curve));
        for (const Obstacle& obstacle : follower->obstacles()) {
            SceneArea area{.color = Theme::color(ColorRole::Warning), .hatched = true};
            if (obstacle.radius > 0) {
                const auto radius = static_cast<float>(obstacle.radius / axes.metresPerUnit);
                area.outline = widgets::circleOnGround(drawn(obstacle.outline.front()), radius, drawn.up());
            } else {
                for (const Vec2d& corner : obstacle.outline)
                    area.outline.push_back(drawn(corner));
            }
            marks.areas.push_back(std::move(area));
        }
    }
    m_viewport.setMarks(QStringLiteral("livePath"), marks);
}

} // namespace quadrille

#include "moc_livepaths.cpp"
