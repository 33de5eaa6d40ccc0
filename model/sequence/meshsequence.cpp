// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/meshsequence.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tbb/parallel_for.h>

namespace quadrille {

namespace {

void checkFinite(Positions positions, const FrameSource& source, FrameIndex frame)
{
    // Infinity and what is no number have all bits of the exponent set. Without an early end, and with whole
    // numbers, whose order of summing is free, the loop vectorises.
    constexpr std::uint32_t exponent = 0x7F80'0000;
    std::uint32_t bad = 0;
    for (const Vec3f& p : positions) {
        for (int axis = 0; axis < 3; ++axis)
            bad |= static_cast<std::uint32_t>((std::bit_cast<std::uint32_t>(p[axis]) & exponent) == exponent);
    }
    if (bad == 0)
        return;
    const auto first =
        std::find_if(positions.begin(), positions.end(), [](const Vec3f& p) { return !p.allFinite(); });
    throw Error(
        ErrorCode::NonFiniteCoordinate,
        {source.fileOf(frame), {.frame = frame}, {{"vertex", std::to_string(first - positions.begin())}}});
}

template <typename Span>
std::vector<Span> cutSpans(const std::vector<Span>& spans, FrameRange frames)
{
    std::vector<Span> cut;
    for (Span span : spans) {
        const FrameIndex first = std::max(span.frames.first, frames.first);
        const FrameIndex last = std::min(span.frames.last, frames.last);
        if (last < first)
            continue;
        span.frames = {FrameIndex(first.value - frames.first.value),
                       FrameIndex(last.value - frames.first.value)};
        cut.push_back(std::move(span));
    }
    return cut;
}

/// Frames of another source at another rate, linear in time.
class ResampledFrames : public FrameSource
{
public:
    ResampledFrames(std::shared_ptr<const FrameSource> source, FrameRange range, double step,
                    std::int64_t frameCount)
        : m_source(std::move(source)), m_range(range), m_step(step), m_frameCount(frameCount)
    {
    }
    std::int64_t frameCount() const override { return m_frameCount; }
    std::uint32_t vertexCount() const override { return m_source->vertexCount(); }
    std::filesystem::path fileOf(FrameIndex frame) const override
    {
        return m_source->fileOf(before(frame).first);
    }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        const auto [first, weight] = before(frame);
        m_source->read(first, out);
        if (weight == 0.0F)
            return;
        std::vector<Vec3f> next(out.size());
        m_source->read(FrameIndex(first.value + 1), next);
        for (std::size_t v = 0; v < out.size(); ++v)
            out[v] += weight * (next[v] - out[v]);
    }

private:
    /// The source frame at or before a frame, and how far the time is on the way to the next one.
    std::pair<FrameIndex, float> before(FrameIndex frame) const
    {
        const double last = static_cast<double>(m_range.count() - 1);
        const double time = std::min(static_cast<double>(frame.value) * m_step, last);
        const double whole = std::floor(time + 1e-9);
        const double rest = std::max(0.0, time - whole);
        return {FrameIndex(m_range.first.value + static_cast<std::int64_t>(whole)),
                rest < 1e-6 ? 0.0F : static_cast<float>(rest)};
    }

    std::shared_ptr<const FrameSource> m_source;
    FrameRange m_range;
    double m_step; ///< source frames per frame
    std::int64_t m_frameCount;
};

/// Frames of another source, every position multiplied by a matrix.
class TransformedFrames : public FrameSource
{
public:
    TransformedFrames(std::shared_ptr<const FrameSource> source, const Eigen::Matrix3f& matrix)
        : m_source(std::move(source)), m_matrix(matrix)
    {
    }
    std::int64_t frameCount() const override { return m_source->frameCount(); }
    std::uint32_t vertexCount() const override { return m_source->vertexCount(); }
    std::filesystem::path fileOf(FrameIndex frame) const override { return m_source->fileOf(frame); }
    void read(FrameIndex frame, MutablePositions out) const override
    {
        m_source->read(frame, out);
        for (Vec3f& p : out)
            p = m_matrix * p;
    }

private:
    std::shared_ptr<const FrameSource> m_source;
    Eigen::Matrix3f m_matrix;
};

} // namespace

Frame MeshSequence::frame(FrameIndex frame, MediaCache& cache) const
{
    const FrameIndex wanted = sourceFrame(frame);
    if (const auto view = source->view(wanted)) {
        checkFinite(*view, *source, wanted);
        return {*view, source};
    }
    const auto item = cache.get(source->id(), wanted.value, [&] {
        auto positions = std::make_shared<std::vector<Vec3f>>(source->vertexCount());
        source->read(wanted, *positions);
        checkFinite(*positions, *source, wanted);
        return MediaCache::Loaded{positions, positions->size() * sizeof(Vec3f)};
    });
    const auto& positions = *static_cast<const std::vector<Vec3f>*>(item.get());
    return {positions, item};
}

std::shared_ptr<const Image> MeshSequence::texture(FrameIndex frame, int material, MediaCache& cache) const
{
    return textures.image(textures.indexFor(sourceFrame(frame), material), cache);
}

MeshSequence MeshSequence::cutTo(FrameRange frames) const
{
    if (frames.first.value < 0 || frames.last.value >= frameCount() || frames.count() == 0) {
        throw Error(ErrorCode::RangeOutside,
                    {source ? source->fileOf(FrameIndex(0)) : std::filesystem::path(),
                     {},
                     {{"first", std::to_string(frames.first.value)},
                      {"last", std::to_string(frames.last.value)},
                      {"count", std::to_string(frameCount())}}});
    }
    MeshSequence cut = *this;
    cut.range = {sourceFrame(frames.first), sourceFrame(frames.last)};
    cut.labels = cutSpans(labels, frames);
    cut.contacts = cutSpans(contacts, frames);
    return cut;
}

MeshSequence makeSequence(std::string name, std::shared_ptr<const Topology> topology,
                          std::shared_ptr<const FrameSource> source, double fps)
{
    if (topology->vertexCount() != source->vertexCount()) {
        throw Error(ErrorCode::VertexCountMismatch,
                    {source->fileOf(FrameIndex(0)),
                     {},
                     {{"found", std::to_string(source->vertexCount())},
                      {"expected", std::to_string(topology->vertexCount())}}});
    }
    MeshSequence sequence;
    sequence.name = std::move(name);
    sequence.range = FrameRange::all(source->frameCount());
    sequence.topology = std::move(topology);
    sequence.source = std::move(source);
    sequence.fps = fps;
    return sequence;
}

std::vector<Vec3f> loadFrames(const MeshSequence& sequence, const Progress& progress)
{
    const std::size_t vertices = sequence.source->vertexCount();
    const std::int64_t frames = sequence.frameCount();
    std::vector<Vec3f> all(static_cast<std::size_t>(frames) * vertices);
    std::atomic<std::int64_t> done{0};
    tbb::parallel_for(std::int64_t{0}, frames, [&](std::int64_t f) {
        progress.report(done++, frames);
        const FrameIndex wanted = sequence.sourceFrame(FrameIndex(f));
        const auto out = MutablePositions(all).subspan(static_cast<std::size_t>(f) * vertices, vertices);
        sequence.source->read(wanted, out);
        checkFinite(out, *sequence.source, wanted);
    });
    return all;
}

std::int64_t resampledFrames(std::int64_t frames, double from, double to)
{
    const auto last = static_cast<double>(frames - 1);
    return static_cast<std::int64_t>(std::floor(last * to / from + 1e-9)) + 1;
}

MeshSequence resampled(const MeshSequence& sequence, double fps)
{
    if (!(fps > 0) || !std::isfinite(fps)) {
        throw Error(ErrorCode::BadArgument,
                    {{},
                     {},
                     {{"reason", "A frame rate of " + std::to_string(fps) + " is not possible"},
                      {"remedy", QUADRILLE_MESSAGE("Give a positive number of frames a second.")}}});
    }
    if (fps == sequence.fps)
        return sequence;
    const double step = sequence.fps / fps;
    const std::int64_t frameCount = resampledFrames(sequence.frameCount(), sequence.fps, fps);
    const auto nearest = [step](FrameIndex frame) {
        return static_cast<std::int64_t>(std::floor(static_cast<double>(frame.value) * step + 0.5));
    };
    MeshSequence result = sequence;
    result.source = std::make_shared<ResampledFrames>(sequence.source, sequence.range, step, frameCount);
    result.range = FrameRange::all(frameCount);
    result.fps = fps;
    if (sequence.textures.kind() == TextureSet::Kind::PerFrame) {
        std::vector<Texture> textures;
        for (std::int64_t f = 0; f < frameCount; ++f) {
            const auto source =
                sequence.sourceFrame(FrameIndex(std::min(nearest(FrameIndex(f)), sequence.frameCount() - 1)));
            textures.push_back(sequence.textures.textures().at(static_cast<std::size_t>(source.value)));
        }
        result.textures = TextureSet::perFrame(std::move(textures)).blendedBy(sequence.textures.blender());
    }
    const auto convert = [&](FrameRange& frames) {
        const auto toNew = [&](FrameIndex frame) {
            const auto converted =
                static_cast<std::int64_t>(std::floor(static_cast<double>(frame.value) / step + 0.5));
            return FrameIndex(std::min(converted, frameCount - 1));
        };
        frames = {toNew(frames.first), toNew(frames.last)};
    };
    for (LabelSpan& span : result.labels)
        convert(span.frames);
    for (ContactSpan& span : result.contacts)
        convert(span.frames);
    return result;
}

MeshSequence transformed(const MeshSequence& sequence, const Eigen::Matrix3f& matrix)
{
    if (matrix == Eigen::Matrix3f::Identity())
        return sequence;
    MeshSequence result = sequence;
    result.source = std::make_shared<TransformedFrames>(sequence.source, matrix);
    return result;
}

} // namespace quadrille
