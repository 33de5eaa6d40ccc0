// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/clipcamera.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

/// Means over a window around each entry, narrower at both ends.
std::vector<Vec3d> smoothed(const std::vector<Vec3d>& path, std::size_t radius)
{
    std::vector<Vec3d> result(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::size_t reach = std::min({radius, i, path.size() - 1 - i});
        Vec3d sum = Vec3d::Zero();
        for (std::size_t k = i - reach; k <= i + reach; ++k)
            sum += path[k];
        result[i] = sum / static_cast<double>(2 * reach + 1);
    }
    return result;
}

struct Travel
{
    std::vector<Vec3d> path;
    Bounds whole;
    Bounds aroundPath; ///< the figure as one sees it who goes along
};

Travel travelOf(const MeshSequence& sequence, UpAxis up, const Progress& progress)
{
    Travel travel;
    std::vector<Bounds> boxes;
    const auto vertical = static_cast<Eigen::Index>(up);
    for (std::int64_t f = 0; f < sequence.frameCount(); ++f) {
        progress.report(f, sequence.frameCount());
        const Frame frame = sequence.frame(FrameIndex(f));
        Vec3d sum = Vec3d::Zero();
        for (const Vec3f& p : frame.positions())
            sum += p.cast<double>();
        Vec3d middle = sum / static_cast<double>(frame.positions().size());
        if (f > 0)
            middle[vertical] = travel.path.front()[vertical];
        travel.path.push_back(middle);
        boxes.push_back(boundsOf(frame.positions()));
        travel.whole.add(boxes.back());
    }
    const auto radius = static_cast<std::size_t>(std::clamp(sequence.fps * 0.25, 1.0, 1000.0));
    travel.path = smoothed(smoothed(travel.path, radius), radius);
    for (std::size_t f = 0; f < boxes.size(); ++f) {
        const Vec3d offset = travel.path.front() - travel.path[f];
        travel.aroundPath.add(Bounds{boxes[f].min + offset, boxes[f].max + offset});
    }
    return travel;
}

} // namespace

std::vector<Vec3d> followPath(const MeshSequence& sequence, UpAxis up, const Progress& progress)
{
    return travelOf(sequence, up, progress).path;
}

std::vector<Camera> clipCameras(const MeshSequence& sequence, const RenderSettings& settings,
                                const Progress& progress)
{
    const UpAxis up = settings.look.axes.up;
    const auto count = static_cast<std::size_t>(sequence.frameCount());
    if (!settings.keys.empty()) {
        std::vector<Camera> cameras(count);
        for (std::size_t f = 0; f < count; ++f)
            cameras[f] = toCamera(cameraAt(settings.keys, static_cast<double>(f) / sequence.fps), up);
        return cameras;
    }
    if (settings.camera == CameraMode::Fixed && settings.view)
        return std::vector<Camera>(count, *settings.view);
    const Travel travel = travelOf(sequence, up, progress);
    const Framing framing{.up = up,
                          .aspect = static_cast<double>(settings.look.width) / settings.look.height};
    Camera first;
    if (settings.view)
        first = *settings.view;
    else if (settings.camera == CameraMode::Fixed)
        first = frameAll(travel.whole, framing);
    else if (settings.camera == CameraMode::Follow)
        first = frameAll(travel.aroundPath, framing);
    else
        first = frameTurntable(travel.aroundPath, framing);

    std::vector<Camera> cameras(count, first);
    if (settings.camera == CameraMode::Fixed)
        return cameras;
    for (std::size_t f = 0; f < count; ++f) {
        if (settings.camera == CameraMode::Turntable)
            cameras[f] =
                turned(first, up, settings.revolutions * static_cast<double>(f) / static_cast<double>(count));
        cameras[f] = moved(cameras[f], travel.path[f] - travel.path.front());
    }
    return cameras;
}

} // namespace quadrille
