// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/projection/projectclip.h"

#include "model/appearance/spreadtexels.h"
#include "model/render/color.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <mutex>

namespace quadrille {

namespace {

using TexelColour = ProjectedTexels::Colour;

ProjectedTexels projectFrame(const TextureProjector& projector, const MeshSequence& clip,
                             const FramePicture& picture, FrameIndex frame, const Progress& progress)
{
    std::vector<std::shared_ptr<const Image>> pictures;
    for (std::size_t c = 0; c < projector.cameras().size(); ++c) {
        progress.report(0);
        pictures.push_back(picture(c, frame));
    }
    return projector.project(clip.frame(frame).positions(), pictures, progress);
}

/// Frames spread evenly over a clip.
std::vector<FrameIndex> spreadFrames(std::int64_t count, std::int64_t most)
{
    std::vector<FrameIndex> frames;
    const std::int64_t taken = std::min(count, most);
    for (std::int64_t i = 0; i < taken; ++i)
        frames.emplace_back((2 * i + 1) * count / (2 * taken));
    return frames;
}

std::uint8_t crossfaded(std::uint8_t own, std::uint8_t other, std::uint8_t trust)
{
    const SrgbTables& tables = SrgbTables::instance();
    const float share = static_cast<float>(trust) / 255;
    return tables.toSrgb(share * tables.toLinear(own) + (1 - share) * tables.toLinear(other));
}

/// What a task finds out about a frame: figures, which texels are seen, and the texture, as bytes.
struct FrameBytes
{
    std::size_t figures = 0; ///< counts, all in bytes
    std::size_t seen = 0;
    std::size_t pixels = 0;

    TaskSet::Result packed(const std::vector<double>& numbers, const ProjectedTexels& projected,
                           const Image& texture) const
    {
        TaskSet::Result bytes(figures + seen + pixels);
        std::memcpy(bytes.data(), numbers.data(), figures);
        for (std::size_t t = 0; t < seen; ++t)
            bytes[figures + t] = std::byte{projected.colours[t].trust > 0};
        std::memcpy(bytes.data() + figures + seen, texture.pixels.data(), pixels);
        return bytes;
    }
};

std::vector<TexelColour> fillOf(const TextureProjector& projector, const MeshSequence& clip,
                                const FramePicture& picture, const Progress& progress,
                                const Executor& executor)
{
    constexpr std::int64_t most = 15;
    const std::vector<FrameIndex> frames = spreadFrames(clip.frameCount(), most);
    std::vector<std::vector<TexelColour>> projected(frames.size());
    executor.run(makeTasks<TexelColour>(
                     std::ssize(frames),
                     [&](std::int64_t task, const Progress& own) {
                         return projectFrame(projector, clip, picture, frames[static_cast<std::size_t>(task)],
                                             own)
                             .colours;
                     },
                     [&](std::int64_t task, std::span<const TexelColour> colours) {
                         projected[static_cast<std::size_t>(task)].assign(colours.begin(), colours.end());
                     }),
                 progress);
    return medianColours(projected);
}

} // namespace

std::vector<TexelColour> medianColours(std::span<const std::vector<TexelColour>> frames)
{
    std::vector<TexelColour> medians(frames.front().size());
    std::vector<std::uint8_t> values;
    for (std::size_t t = 0; t < medians.size(); ++t) {
        std::uint8_t best = 0;
        for (const auto& frame : frames)
            best = std::max(best, frame[t].trust);
        if (best == 0)
            continue;
        medians[t].trust = best;
        for (const auto channel : {&TexelColour::red, &TexelColour::green, &TexelColour::blue}) {
            values.clear();
            for (const auto& frame : frames)
                if (2 * frame[t].trust >= best)
                    values.push_back(frame[t].*channel);
            const auto middle = values.begin() + (std::ssize(values) - 1) / 2;
            std::nth_element(values.begin(), middle, values.end());
            medians[t].*channel = *middle;
        }
    }
    return medians;
}

Image filledTexture(const AtlasTexels& atlas, std::span<const TexelColour> texels,
                    std::span<const TexelColour> fill)
{
    assert(texels.size() == atlas.places.size() && (fill.empty() || fill.size() == texels.size()));
    Image texture(atlas.width, atlas.height);
    UsedTexels known{.width = atlas.width, .height = atlas.height};
    for (std::size_t t = 0; t < texels.size(); ++t) {
        TexelColour colour = texels[t];
        if (!fill.empty() && fill[t].trust > 0) {
            for (const auto channel : {&TexelColour::red, &TexelColour::green, &TexelColour::blue})
                colour.*channel = crossfaded(colour.*channel, fill[t].*channel, colour.trust);
        } else if (!fill.empty() && colour.trust == 0) {
            continue;
        }
        const std::uint32_t texel = atlas.places[t].texel;
        std::uint8_t* pixel = texture.pixels.data() + 4 * std::size_t{texel};
        pixel[0] = colour.red;
        pixel[1] = colour.green;
        pixel[2] = colour.blue;
        known.texels.push_back(texel);
    }
    spreadTexels(known, texture);
    return texture;
}

ProjectedClip projectClip(const TextureProjector& projector, const MeshSequence& clip,
                          const FramePicture& picture, bool fills, const TakeTexture& take,
                          const Progress& progress, const Executor& executor)
{
    const AtlasTexels& atlas = projector.atlas();
    const std::size_t texels = static_cast<std::size_t>(atlas.width) * static_cast<std::size_t>(atlas.height);
    const std::size_t cameras = projector.cameras().size();
    ProjectedClip projected{.frames = std::vector<FrameCoverage>(static_cast<std::size_t>(clip.frameCount())),
                            .timesSeen = std::vector<std::int32_t>(texels)};
    std::vector<TexelColour> fill;
    const double begin = fills ? 0.3 : 0;
    if (fills && clip.frameCount() > 0)
        fill = fillOf(projector, clip, picture, progress.part(0, begin), executor);
    const FrameBytes layout{(2 + cameras) * sizeof(double), atlas.places.size(), 4 * texels};
    std::mutex mutex;
    const TaskSet tasks{
        .count = clip.frameCount(),
        .compute =
            [&](std::int64_t task, const Progress& own) {
                const ProjectedTexels frame =
                    projectFrame(projector, clip, picture, FrameIndex(task), own.part(0, 0.9));
                std::vector<double> figures{static_cast<double>(frame.seen) /
                                                static_cast<double>(atlas.places.size()),
                                            static_cast<double>(frame.sights) /
                                                static_cast<double>(std::max<std::int64_t>(frame.seen, 1))};
                figures.insert(figures.end(), frame.shares.begin(), frame.shares.end());
                return layout.packed(figures, frame, filledTexture(atlas, frame.colours, fill));
            },
        .store =
            [&](std::int64_t task, std::span<const std::byte> result) {
                std::vector<double> figures(2 + cameras);
                std::memcpy(figures.data(), result.data(), layout.figures);
                projected.frames[static_cast<std::size_t>(task)] = {
                    figures[0], figures[1], {figures.begin() + 2, figures.end()}};
                {
                    const std::scoped_lock lock(mutex);
                    for (std::size_t t = 0; t < layout.seen; ++t)
                        projected.timesSeen[atlas.places[t].texel] +=
                            std::to_integer<std::int32_t>(result[layout.figures + t]);
                }
                Image texture(atlas.width, atlas.height);
                std::memcpy(texture.pixels.data(), result.data() + layout.figures + layout.seen,
                            layout.pixels);
                take(FrameIndex(task), texture);
            }};
    executor.run(tasks, progress.part(begin, 1));
    return projected;
}

} // namespace quadrille
