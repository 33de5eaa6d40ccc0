// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathforms.h"

#include "editor/context/editorcontext.h"
#include "editor/fields/axesfields.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/results/openanimation.h"

#include <QLocale>

namespace quadrille {

PathForm::PathForm(PathTool& tool)
    : m_tool(tool), m_fields(*this, [this](const QString& text, const char* property, const auto& change) {
        edit(text, property, change);
    })
{
    m_fields.addChoice(
        {"pathCurve", [] { return tr("Curve"); }, [] { return tr("How the path goes from point to point"); }},
        &PathEntry::curve,
        {[] { return tr("Smooth through points"); }, [] { return tr("Straight lines"); },
         [] { return tr("Bézier with handles"); }});
    m_fields.addChoice(
        {"pathSpace", [] { return tr("Leads"); },
         [] { return tr("Whether the heights of its points count, or it is seen from above"); }},
        &PathEntry::inSpace, {[] { return tr("Over the ground"); }, [] { return tr("Through space"); }});
    m_fields.addNumber({"pathClearance", [] { return tr("Clearance"); },
                        [] { return tr("The distance that the body’s centre keeps from obstacles"); },
                        [](const PathEntry& path) { return !path.obstacles.empty(); },
                        [] { return tr("Change the clearance"); }},
                       &PathEntry::clearance, lengthLook(tool, "path.clearance", 0, 0.05));
    m_length = addFact("pathLength", [] { return tr("Length"); });
    m_result = addFact("pathResult", [] { return tr("Deviation"); });
    m_result->setToolTip(tr("How far the body’s centre is from where it was to be"));
    retranslate();
}

/// Points follow the kind of curve, and so does the path that is drawn next: that is the tool's.
void PathForm::edit(const QString& text, const char* property, const PathTool::Edit& change)
{
    const PathEntry& before = shown();
    PathEntry after = before;
    change(after);
    if (after.curve != before.curve)
        m_tool.setCurve(after.curve);
    else if (after.inSpace != before.inSpace)
        m_tool.setInSpace(after.inSpace);
    else if (m_tool.path() != nullptr)
        m_tool.edit(text, QLatin1String(property), change);
}

const PathEntry& PathForm::shown() const
{
    const PathEntry* path = m_tool.path();
    return path == nullptr ? m_tool.blank() : *path;
}

QString PathForm::resultText() const
{
    const auto result = m_tool.animation().result();
    if (!result || !result->walk.constraints.path)
        return QStringLiteral("–");
    const WalkSolution& solution = result->walk.solution;
    const auto centimetres = [](double metres) {
        return tr("%1 cm").arg(QLocale().toString(metres * 100, 'f', 1));
    };
    return tr("mean %1\ngreatest %2")
        .arg(centimetres(solution.meanDeviation), centimetres(solution.greatestDeviation));
}

void PathForm::refresh()
{
    m_fields.show(shown());
    m_length->setText(QStringLiteral("%1 %2").arg(lengthText(m_tool, m_tool.length()), unitOf(m_tool)));
    m_result->setText(resultText());
}

void PathForm::retranslate()
{
    m_fields.retranslate();
    refresh();
}

ObstacleForm::ObstacleForm(PathTool& tool)
    : m_tool(tool)
    , m_fields(*this, [this](const QString& text, const char* /*property*/, const auto& change) {
        if (obstacle() == nullptr)
            return;
        m_tool.edit(text, QStringLiteral("path obstacle %1").arg(m_obstacle),
                    [&](PathEntry& path) { change(path.obstacles[static_cast<std::size_t>(m_obstacle)]); });
    })
{
    addMiddle("obstacleFirst", 0);
    addMiddle("obstacleSecond", 1);
    m_fields.addNumber({"obstacleRadius", [] { return tr("Radius"); }, [] { return tr("Of the disc"); },
                        &ObstacleEntry::isDisc, [] { return tr("Change the radius of an obstacle"); }},
                       &ObstacleEntry::radius, lengthLook(tool, "obstacle.radius", 0.01, 0.05));
}

void ObstacleForm::addMiddle(const char* name, int axis)
{
    const auto middle = [axis](const ObstacleEntry& obstacle) {
        double sum = 0;
        for (const Vec2d& corner : obstacle.corners)
            sum += corner[axis];
        return sum / static_cast<double>(obstacle.corners.size());
    };
    m_fields.addNumber(
        {name,
         [this, axis] { return tr("Middle %1").arg(groundAxisName(settingsOf(m_tool).axes.up, axis)); },
         [] { return tr("Where the middle of the obstacle is on the ground"); },
         {},
         [] { return tr("Move an obstacle"); }},
        Lens<ObstacleEntry, double>{middle,
                                    [=](ObstacleEntry& obstacle, double to) {
                                        const double way = to - middle(obstacle);
                                        for (Vec2d& corner : obstacle.corners)
                                            corner[axis] += way;
                                    }},
        lengthLook(m_tool, nullptr, -1, 0.1));
}

const ObstacleEntry* ObstacleForm::obstacle() const
{
    const PathEntry* path = m_tool.path();
    const bool isThere =
        path != nullptr && m_obstacle >= 0 && m_obstacle < static_cast<int>(path->obstacles.size());
    return isThere ? &path->obstacles[static_cast<std::size_t>(m_obstacle)] : nullptr;
}

void ObstacleForm::showObstacle(int index)
{
    m_obstacle = index;
    const ObstacleEntry* shown = obstacle();
    setVisible(shown != nullptr);
    if (shown != nullptr)
        m_fields.show(*shown);
}

void ObstacleForm::retranslate()
{
    m_fields.retranslate();
    showObstacle(m_obstacle);
}

} // namespace quadrille

#include "moc_pathforms.cpp"
