// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/thumbnail.h"

#include "model/render/renderframe.h"

#include <algorithm>

namespace quadrille {

RenderOptions thumbnailLook(int width, int height, RenderOptions::Background background,
                            const CoordinateSystem& axes)
{
    RenderOptions look;
    look.width = width;
    look.height = height;
    look.supersampling = 3;
    look.background = background;
    look.axes = axes;
    return look;
}

Image thumbnail(const MeshSequence& sequence, const RenderOptions& look)
{
    const FrameIndex frame(sequence.frameCount() / 3);
    const Camera camera = figureCameras(sequence, {frame}, look).front();
    return renderFrame(sequence, frame, camera, look);
}

std::vector<Image> thumbnailStrip(const MeshSequence& sequence, int count, const RenderOptions& look,
                                  const Progress& progress)
{
    const std::int64_t number = std::min<std::int64_t>(count, sequence.frameCount());
    std::vector<FrameIndex> frames;
    for (std::int64_t i = 0; i < number; ++i)
        frames.emplace_back(i * sequence.frameCount() / number);
    const FrameRenderer renderer(sequence, look);
    const auto cameras = figureCameras(sequence, frames, look);
    std::vector<Image> strip(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        progress.report(static_cast<std::int64_t>(i), number);
        strip[i] = renderer.render(frames[i], cameras[i]);
    }
    return strip;
}

std::vector<FrameIndex> evenFrames(std::int64_t frameCount, int count)
{
    const std::int64_t number = std::min<std::int64_t>(std::max(count, 0), frameCount);
    std::vector<FrameIndex> frames;
    for (std::int64_t i = 0; i < number; ++i)
        frames.emplace_back(number > 1 ? i * (frameCount - 1) / (number - 1) : frameCount / 3);
    return frames;
}

std::vector<Camera> figureCameras(const MeshSequence& sequence, const std::vector<FrameIndex>& frames,
                                  const RenderOptions& look)
{
    if (frames.empty())
        return {};
    constexpr std::size_t pointLimit = 20000; // plenty for an outline
    const std::size_t total = sequence.topology->vertexCount() * frames.size();
    const std::size_t stride = total / pointLimit + 1;
    const auto vertical = static_cast<Eigen::Index>(look.axes.up);
    std::vector<Vec3d> offsets;
    std::vector<Vec3d> points;
    Vec3d first = Vec3d::Zero();
    for (const FrameIndex f : frames) {
        const Frame frame = sequence.frame(f);
        Vec3d sum = Vec3d::Zero();
        for (const Vec3f& p : frame.positions())
            sum += p.cast<double>();
        Vec3d offset = sum / static_cast<double>(frame.positions().size());
        if (offsets.empty())
            first = offset;
        offset -= first;
        offset[vertical] = 0;
        offsets.push_back(offset);
        for (std::size_t v = 0; v < frame.positions().size(); v += stride)
            points.emplace_back(frame.positions()[v].cast<double>() - offset);
    }
    const Camera camera = frameAll(
        points,
        {.up = look.axes.up, .aspect = static_cast<double>(look.width) / look.height, .margin = 0.08});
    std::vector<Camera> cameras;
    cameras.reserve(offsets.size());
    for (const Vec3d& offset : offsets)
        cameras.push_back(moved(camera, offset));
    return cameras;
}

} // namespace quadrille
