// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/clipexport.h"

#include "model/audio/soundtrack.h"
#include "model/core/file.h"
#include "model/core/seriesname.h"
#include "model/core/stagedfiles.h"
#include "model/film/avifilm.h"
#include "model/film/mp4film.h"
#include "model/render/clipcamera.h"
#include "model/render/renderframe.h"

#include <algorithm>
#include <optional>
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
        RenderSettings settings = settingsFor(options);
        if (settings.look.background == RenderOptions::Background::Transparent) {
            throw Error(ErrorCode::FormatCannotStore,
                        {out, {}, {{"format", "Video"}, {"what", "transparency"}}});
        }
        ExportResult result{{out}, {}};
        if (holdsSound(out) && makeEven(settings.look)) {
            tell(result, out,
                 "The film is " + sizeText(settings.look.width, settings.look.height) +
                     " pixels large: MP4 takes even sizes only.");
        }
        std::optional<Mp3Stream> sound;
        if (options.sound && holdsSound(out))
            sound = soundOf(sequence, out, *options.sound, progress.part(0, 0.05));
        else if (options.sound)
            tell(result, out, "The sound was left out: only MP4 videos hold it.");
        const auto write = [&](const fs::path& temporary) {
            const FilmFormat film{settings.look.width, settings.look.height, sequence.fps,
                                  sequence.frameCount()};
            const auto writer = writerOf(temporary, out, film, std::move(sound));
            drawClip(
                sequence, settings, progress.part(0.05, 1), [](FrameIndex, Image&) {},
                [&](FrameIndex, const Image& image) { writer->add(image); });
            writer->finish();
        };
        writeGuarded(out, write, options.guard);
        return result;
    }

private:
    static bool holdsSound(const fs::path& out) { return out.extension() != ".avi"; }

    static void tell(ExportResult& result, const fs::path& out, std::string text)
    {
        Issue& issue = result.issues.emplace_back();
        issue.context.file = out;
        issue.context.values = {{"text", std::move(text)}};
    }

    /// Draws a column or a row more where one is missing. \return whether there is.
    static bool makeEven(RenderOptions& look)
    {
        const bool isOdd = look.width % 2 != 0 || look.height % 2 != 0;
        look.width += look.width % 2;
        look.height += look.height % 2;
        return isOdd;
    }

    static std::unique_ptr<FilmWriter> writerOf(const fs::path& temporary, const fs::path& out,
                                                const FilmFormat& film, std::optional<Mp3Stream> sound)
    {
        if (out.extension() == ".avi")
            return std::make_unique<AviFilm>(temporary, out, film);
        return std::make_unique<Mp4Film>(temporary, out, film, std::move(sound));
    }

    static Mp3Stream soundOf(const MeshSequence& sequence, const fs::path& out, const SoundTrack& track,
                             const Progress& progress)
    {
        const double seconds = static_cast<double>(sequence.frameCount()) / sequence.fps;
        const Sound sound = readSound(track.file, progress.part(0, 0.3));
        try {
            return encodeMp3(soundOfClip(sound, track, seconds), progress.part(0.3, 1));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::Cancelled)
                throw;
            throw Error(error.code(), {out, {}, error.context().values});
        }
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
