// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/pathforms.h"

#include "editor/context/editorcontext.h"
#include "editor/workspaces/animate/currentanimation.h"
#include "editor/workspaces/animate/pathfields.h"
#include "editor/workspaces/animate/pathtool.h"
#include "model/project/results/openanimation.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLocale>
#include <QSignalBlocker>
#include <array>

namespace quadrille {

namespace {

/// The ground's axes in their order in the project.
std::array<int, 2> groundAxes(const PathTool& tool)
{
    const int up = static_cast<int>(settingsOf(tool).axes.up);
    return {up == 0 ? 1 : 0, up == 2 ? 1 : 2};
}

QString axisName(int axis)
{
    return QString(QLatin1Char(static_cast<char>('x' + axis)));
}

} // namespace

PathForm::PathForm(PathTool& tool)
    : m_tool(tool), m_curve(new QComboBox), m_space(new QComboBox), m_clearance(numberField(0, 2, 0.05))
{
    m_curve->addItems({{}, {}, {}});
    m_space->addItems({{}, {}});
    addField(
        "pathCurve", [] { return tr("Curve"); }, m_curve,
        [] { return tr("How the path goes from point to point"); });
    addField(
        "pathSpace", [] { return tr("Leads"); }, m_space,
        [] { return tr("Whether the heights of its points count, or it is seen from above"); });
    addField(
        "pathClearance", [] { return tr("Clearance"); }, m_clearance,
        [] { return tr("The distance that the body’s centre keeps from obstacles"); });
    m_length = addFact("pathLength", [] { return tr("Length"); });
    m_result = addFact("pathResult", [] { return tr("Deviation"); });
    m_result->setToolTip(tr("How far the body’s centre is from where it was to be"));
    connect(m_curve, &QComboBox::activated, this,
            [this](int index) { m_tool.setCurve(static_cast<PathCurve>(index)); });
    connect(m_space, &QComboBox::activated, this, [this](int index) { m_tool.setInSpace(index == 1); });
    connect(m_clearance, &QDoubleSpinBox::valueChanged, this, [this](double clearance) {
        m_tool.edit(tr("Change the clearance"), QStringLiteral("path clearance"),
                    [&](PathEntry& path) { path.clearance = clearance; });
    });
    show();
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

void PathForm::show(const QString& /*name*/)
{
    m_curve->setItemText(0, tr("Smooth through points"));
    m_curve->setItemText(1, tr("Straight lines"));
    m_curve->setItemText(2, tr("Bézier with handles"));
    m_space->setItemText(0, tr("Over the ground"));
    m_space->setItemText(1, tr("Through space"));
    setUnit(m_tool, {m_clearance});
    const PathEntry* path = m_tool.path();
    const PathEntry& shown = path == nullptr ? m_tool.blank() : *path;
    m_curve->setCurrentIndex(static_cast<int>(shown.curve));
    m_space->setCurrentIndex(shown.inSpace ? 1 : 0);
    setValue(m_clearance, shown.clearance);
    setFieldVisible(m_clearance, !shown.obstacles.empty());
    m_length->setText(QStringLiteral("%1 %2").arg(lengthText(m_tool, m_tool.length()), unitOf(m_tool)));
    m_result->setText(resultText());
}

ObstacleForm::ObstacleForm(PathTool& tool)
    : m_tool(tool)
    , m_first(numberField(-1, 2, 0.1))
    , m_second(numberField(-1, 2, 0.1))
    , m_radius(numberField(0.01, 2, 0.05))
{
    addField(
        "obstacleFirst", [this] { return tr("Middle %1").arg(axisName(groundAxes(m_tool)[0])); }, m_first,
        [] { return tr("Where the middle of the obstacle is on the ground"); });
    addField(
        "obstacleSecond", [this] { return tr("Middle %1").arg(axisName(groundAxes(m_tool)[1])); }, m_second,
        [] { return tr("Where the middle of the obstacle is on the ground"); });
    addField(
        "obstacleRadius", [] { return tr("Radius"); }, m_radius, [] { return tr("Of the disc"); });
    connect(m_first, &QDoubleSpinBox::valueChanged, this, [this](double to) { move(0, to); });
    connect(m_second, &QDoubleSpinBox::valueChanged, this, [this](double to) { move(1, to); });
    connect(m_radius, &QDoubleSpinBox::valueChanged, this, [this](double radius) {
        edit(tr("Change the radius of an obstacle"),
             [radius](ObstacleEntry& obstacle) { obstacle.radius = radius; });
    });
}

const ObstacleEntry* ObstacleForm::obstacle() const
{
    const PathEntry* path = m_tool.path();
    const bool isThere =
        path != nullptr && m_obstacle >= 0 && m_obstacle < static_cast<int>(path->obstacles.size());
    return isThere ? &path->obstacles[static_cast<std::size_t>(m_obstacle)] : nullptr;
}

void ObstacleForm::edit(const QString& text, const std::function<void(ObstacleEntry&)>& edit)
{
    if (obstacle() == nullptr)
        return;
    m_tool.edit(text, QStringLiteral("path obstacle %1").arg(m_obstacle),
                [&](PathEntry& path) { edit(path.obstacles[static_cast<std::size_t>(m_obstacle)]); });
}

void ObstacleForm::move(int axis, double to)
{
    edit(tr("Move an obstacle"), [&](ObstacleEntry& obstacle) {
        double middle = 0;
        for (const Vec2d& corner : obstacle.corners)
            middle += corner[axis] / static_cast<double>(obstacle.corners.size());
        for (Vec2d& corner : obstacle.corners)
            corner[axis] += to - middle;
    });
}

void ObstacleForm::showObstacle(int obstacle)
{
    m_obstacle = obstacle;
    show();
}

void ObstacleForm::show(const QString& /*name*/)
{
    const ObstacleEntry* shown = obstacle();
    setVisible(shown != nullptr);
    if (shown == nullptr)
        return;
    setUnit(m_tool, {m_first, m_second, m_radius});
    Vec2d middle = Vec2d::Zero();
    for (const Vec2d& corner : shown->corners)
        middle += corner / static_cast<double>(shown->corners.size());
    setValue(m_first, middle.x());
    setValue(m_second, middle.y());
    setFieldVisible(m_radius, shown->isDisc());
    setValue(m_radius, shown->radius);
}

} // namespace quadrille
