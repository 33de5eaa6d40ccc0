// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/sequences/posecomparison.h"

#include "editor/context/editorcontext.h"
#include "editor/playback/poseheatmap.h"
#include "widgets/viewport/viewport.h"

#include <utility>

namespace quadrille {

using widgets::Shading;

PoseComparison::PoseComparison(EditorContext& context, widgets::Viewport& viewport, ClipScene& scene,
                               QObject* parent)
    : QObject(parent)
    , m_context(context)
    , m_viewport(viewport)
    , m_scene(scene)
    , m_heatMap(new PoseHeatMap(viewport, scene, context.jobs, this))
{
    m_action = context.actions.action(QStringLiteral("view.heatMap"));
    connect(m_action, &QAction::toggled, this, &PoseComparison::setOn);
    // One of a group stays checked when it is triggered again: then it gives way to the one before it.
    connect(m_action, &QAction::triggered, this, [this] {
        if (!std::exchange(m_isNew, false) && m_viewport.isVisible())
            goBack();
    });
    connect(m_heatMap, &PoseHeatMap::changed, this, &PoseComparison::changed);
    connect(&scene, &ClipScene::changed, this, [this] {
        if (m_action->isChecked() && m_viewport.isVisible() && !m_scene.isComparing())
            goBack();
    });
}

void PoseComparison::setOn(bool on)
{
    m_isNew = on;
    if (on) {
        m_before = m_viewport.shading();
        m_viewport.setShading(Shading::Scalar);
    }
    m_heatMap->setOn(on);
}

void PoseComparison::goBack()
{
    const char* action = m_before == Shading::Clay        ? "view.clay"
                         : m_before == Shading::Wireframe ? "view.wire"
                                                          : "view.textured";
    m_context.actions.action(QLatin1String(action))->setChecked(true);
}

QString PoseComparison::problem() const
{
    switch (m_heatMap->state()) {
    case PoseHeatMap::State::NotTwo:
        return tr("The pose distance is shown between two sequences.");
    case PoseHeatMap::State::DifferentMesh:
        return tr("“%1” and “%2” have different meshes.").arg(m_scene.shown()[0], m_scene.shown()[1]);
    default:
        return {};
    }
}

QString PoseComparison::remedy() const
{
    return m_heatMap->state() == PoseHeatMap::State::NotTwo
               ? tr("Select two of them.")
               : tr("Poses can be compared where both belong to one character.");
}

} // namespace quadrille

#include "moc_posecomparison.cpp"
