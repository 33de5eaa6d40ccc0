// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/exporting/seencamera.h"

#include "editor/workspaces/view/sceneview.h"
#include "model/render/clipcamera.h"

#include <algorithm>

namespace quadrille {

namespace {

Vec3d toVector(const QVector3D& v)
{
    return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

} // namespace

std::optional<SeenCamera> seenCamera(SceneView& view, const QString& name, const MeshSequence& clip)
{
    const MeshSequence* shown = view.scene().sequenceOf(name);
    const int figure = view.scene().figureOf(name);
    const auto shape = view.viewport().figureShape(figure);
    if (shown == nullptr || !shape || shown->topology != clip.topology ||
        shown->frameCount() != clip.frameCount())
        return std::nullopt;
    const widgets::Turntable turntable = view.viewport().camera();
    SeenCamera seen;
    seen.camera.eye = toVector(turntable.position() - shape->shift);
    seen.camera.target = toVector(turntable.target - shape->shift);
    seen.camera.up = toVector(turntable.up());
    seen.camera.verticalFovDegrees = static_cast<double>(turntable.fieldOfView);
    seen.follows = view.viewport().followed() == figure;
    seen.frame = FrameIndex(std::min(view.scene().frame().value, clip.frameCount() - 1));
    return seen;
}

Camera firstCamera(const SeenCamera& seen, CameraMode mode, const MeshSequence& film, std::int64_t shown,
                   UpAxis up, const Progress& progress)
{
    if (mode == CameraMode::Fixed)
        return seen.camera;
    const std::vector<Vec3d> path = followPath(film, up, progress);
    const auto at = static_cast<std::size_t>(
        std::clamp<std::int64_t>(shown, 0, static_cast<std::int64_t>(path.size()) - 1));
    return moved(seen.camera, path.front() - path[at]);
}

} // namespace quadrille
