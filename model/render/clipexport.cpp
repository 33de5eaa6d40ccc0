// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/render/clipexport.h"

#include "model/audio/mp4sound.h"
#include "model/audio/soundtrack.h"
#include "model/core/file.h"
#include "model/core/message.h"
#include "model/core/seriesname.h"
#include "model/core/stagedfiles.h"
#include "model/render/clipcamera.h"
#include "model/render/renderframe.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <utility>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// The export's settings, in the coordinates of the sequence that an exporter is given.
RenderSettings settingsFor(const ExportOptions& options)
{
    RenderSettings settings = options.render;
    settings.look.axes = options.to;
    return settings;
}

class PngExporter : public Exporter
{
public:
    const FormatInfo& format() const override
    {
        static const FormatInfo info{
            .id = "png", .name = "PNG pictures", .extensions = {".png"}, .onePerFrame = true};
        return info;
    }

    ExportResult write(const MeshSequence& sequence, const fs::path& out, const ExportOptions& options,
                       const Progress& progress) const override
    {
        StagedFiles files(out.parent_path(), options.guard);
        drawClip(
            sequence, settingsFor(options), progress,
            [&](FrameIndex frame, Image& image) {
                writeImage(image, files.add(numberedName(out, frame.value, sequence.frameCount())));
                image = {};
            },
            [](FrameIndex, const Image&) {});
        return {files.commit(), {}};
    }
};

class VideoExporter : public Exporter
{
public:
    const FormatInfo& format() const override
    {
        static const FormatInfo info{.id = "mp4", .name = "Video", .extensions = {".mp4", ".avi"}};
        return info;
    }

    ExportResult write(const MeshSequence& sequence, const fs::path& out, const ExportOptions& options,
                       const Progress& progress) const override
    {
        const RenderSettings settings = settingsFor(options);
        check(settings.look, out);
        const auto write = [&](const fs::path& temporary) {
            encode(sequence, settings, out, temporary, progress.part(0, 0.95));
            if (options.sound && holdsSound(out))
                addSound(temporary, soundOf(sequence, *options.sound, progress.part(0.95, 1)));
        };
        writeGuarded(out, write, options.guard);
        ExportResult result{{out}, {}};
        if (options.sound && !holdsSound(out)) {
            Issue& issue = result.issues.emplace_back();
            issue.context.file = out;
            issue.context.values = {{"text", "The sound was left out: only MP4 videos hold it."}};
        }
        return result;
    }

private:
    static bool holdsSound(const fs::path& out) { return out.extension() != ".avi"; }

    static Mp3Stream soundOf(const MeshSequence& sequence, const SoundTrack& track, const Progress& progress)
    {
        const double seconds = static_cast<double>(sequence.frameCount()) / sequence.fps;
        const Sound sound = readSound(track.file, progress.part(0, 0.3));
        return encodeMp3(soundOfClip(sound, track, seconds), progress.part(0.3, 1));
    }

    static void check(const RenderOptions& look, const fs::path& out)
    {
        if (look.background == RenderOptions::Background::Transparent) {
            throw Error(ErrorCode::FormatCannotStore,
                        {out, {}, {{"format", "Video"}, {"what", "transparency"}}});
        }
        if (look.width % 2 == 0 && look.height % 2 == 0)
            return;
        throw Error(
            ErrorCode::BadArgument,
            {out,
             {},
             {{"reason", "A video of " + std::to_string(look.width) + " × " + std::to_string(look.height) +
                             " pixels cannot be written: both must be even"},
              {"remedy", "Choose " + std::to_string(look.width + look.width % 2) + " × " +
                             std::to_string(look.height + look.height % 2) + "."}}});
    }

    static void encode(const MeshSequence& sequence, const RenderSettings& settings, const fs::path& out,
                       const fs::path& temporary, const Progress& progress)
    {
        const int codec = out.extension() == ".avi" ? cv::VideoWriter::fourcc('M', 'J', 'P', 'G')
                                                    : cv::VideoWriter::fourcc('m', 'p', '4', 'v');
        const cv::Size size(settings.look.width, settings.look.height);
        cv::VideoWriter writer;
        const auto fail = [&out](const char* reason) {
            throw Error(ErrorCode::WriteFailed, {out, {}, {{"reason", reason}}});
        };
        try {
            if (!writer.open(temporary.string(), codec, sequence.fps, size))
                fail(QUADRILLE_MESSAGE("the video file cannot be opened for encoding"));
        } catch (const cv::Exception&) {
            fail(QUADRILLE_MESSAGE("the video encoder refuses this size or frame rate"));
        }
        cv::Mat encodable;
        drawClip(
            sequence, settings, progress, [](FrameIndex, Image&) {},
            [&](FrameIndex, const Image& image) {
                const cv::Mat picture(size, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
                cv::cvtColor(picture, encodable, cv::COLOR_RGBA2BGR);
                writer.write(encodable);
            });
        writer.release();
        std::error_code error;
        const auto bytes = fs::file_size(temporary, error);
        if (error || bytes == 0)
            fail(QUADRILLE_MESSAGE("the encoder has written nothing"));
    }
};

} // namespace

void drawClip(const MeshSequence& sequence, const RenderSettings& settings, const Progress& progress,
              const std::function<void(FrameIndex, Image&)>& prepare,
              const std::function<void(FrameIndex, const Image&)>& finish)
{
    constexpr double cameraShare = 0.05;
    const FrameRenderer renderer(sequence, settings.look);
    const auto cameras = clipCameras(sequence, settings, progress.part(0, cameraShare));
    const Progress drawing = progress.part(cameraShare, 1);
    using Drawn = std::pair<FrameIndex, Image>;
    std::int64_t next = 0;
    const auto number = [&](tbb::flow_control& control) {
        if (next >= sequence.frameCount())
            control.stop();
        return next++;
    };
    const auto draw = [&](std::int64_t index) {
        const FrameIndex frame(index);
        drawing.report(0);
        Drawn drawn{frame, renderer.render(frame, cameras[static_cast<std::size_t>(index)])};
        drawing.report(0);
        prepare(frame, drawn.second);
        return drawn;
    };
    const auto take = [&](const Drawn& drawn) {
        finish(drawn.first, drawn.second);
        drawing.report(drawn.first.value + 1, sequence.frameCount());
    };
    // Pictures that wait for their turn to be finished hold memory: only a few frames are under way at once.
    const auto atOnce = static_cast<std::size_t>(std::clamp(tbb::this_task_arena::max_concurrency(), 2, 8));
    tbb::parallel_pipeline(atOnce,
                           tbb::make_filter<void, std::int64_t>(tbb::filter_mode::serial_in_order, number) &
                               tbb::make_filter<std::int64_t, Drawn>(tbb::filter_mode::parallel, draw) &
                               tbb::make_filter<Drawn, void>(tbb::filter_mode::serial_in_order, take));
}

std::unique_ptr<Exporter> makePngExporter()
{
    return std::make_unique<PngExporter>();
}

std::unique_ptr<Exporter> makeVideoExporter()
{
    return std::make_unique<VideoExporter>();
}

} // namespace quadrille
