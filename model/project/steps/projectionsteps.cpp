// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/seriesname.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/document/throwinvalid.h"
#include "model/project/fields/writefields.h"
#include "model/project/media/cameratable.h"
#include "model/project/media/sequencesettings.h"
#include "model/project/steps/buildstep.h"
#include "model/project/store/projectionresult.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/tablebuilder.h"
#include "model/projection/projectclip.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// What an entry of “projections” is computed from.
class ProjectionWork
{
public:
    ProjectionWork(const StepMaking& making, ProjectionEntry entry)
        : m_opener(making.opener), m_projectFile(making.projectFile), m_entry(std::move(entry))
    {
    }

    std::string clipName() const { return "projections/" + m_entry.name; }
    std::string character() const { return characterOfClip(m_opener->project(), clipName()); }
    std::vector<std::string> inputs() const { return clipStepsOf(m_opener->project(), m_entry.clip); }

    /// All that the result depends on beside files and clips; what it is called by is not in it.
    std::string settings() const
    {
        ProjectionEntry entry = m_entry;
        entry.name.clear();
        entry.clip.clear();
        entry.cameras.clear();
        std::string text = settingsText(entry);
        const CoordinateSystem& axes = m_opener->project().settings.axes;
        text += std::string(toString(axes.up)) + " " + std::to_string(axes.metresPerUnit);
        if (const SequenceEntry* sequence = sequenceOfClip())
            text += sequenceSettings(m_opener->project(), *sequence);
        return text;
    }

    /// Those of the clip, the table, and for each camera the pictures of its frames in order. Where one is
    /// missing the table stands for it, so that others in other frames are another result.
    std::vector<fs::path> files(const Progress& progress) const
    {
        std::vector<fs::path> all{table()};
        if (const SequenceEntry* sequence = sequenceOfClip()) {
            const auto own = m_opener->filesOf(sequence->name, progress);
            all.insert(all.end(), own.begin(), own.end());
        }
        for (const CameraSeries& series : cameras()) {
            std::int64_t next = 0;
            for (const auto& [frame, picture] : series.pictures) {
                for (; next < frame; ++next)
                    all.push_back(table());
                if (frame >= 0)
                    all.push_back(picture);
                next = frame + 1;
            }
        }
        return all;
    }

    Result compute(const StepContext& context, const Progress& progress) const;

private:
    fs::path table() const { return resolvePath(m_entry.cameras, m_opener->folder()); }
    fs::path folder() const { return projectionFolder(cacheFolder(m_projectFile), m_entry.name); }

    const SequenceEntry* sequenceOfClip() const
    {
        const auto name = nameOfClip(m_entry.clip, "sequences");
        return name ? findSequence(m_opener->project(), *name) : nullptr;
    }

    std::vector<CameraSeries> cameras() const
    {
        return readCameraTable(table(), m_entry.cameraAxes, m_opener->project().settings.axes);
    }

    MeshSequence openClip(const Progress& progress) const
    {
        MeshSequence clip = m_opener->openClip(m_entry.clip, Progress(progress.token()))->sequence;
        if (!clip.topology->hasUvs())
            throw Error(ErrorCode::NoUvs);
        return clip;
    }

    void removeOthers(const std::set<fs::path>& written) const;

    std::shared_ptr<SequenceOpener> m_opener;
    fs::path m_projectFile;
    ProjectionEntry m_entry;
};

/// Null where the camera has no picture of the frame.
std::shared_ptr<const Image> readPicture(const CameraSeries& series, FrameIndex frame)
{
    const fs::path file = series.pictureOf(frame);
    if (file.empty())
        return nullptr;
    auto picture = std::make_shared<const Image>(readImage(file));
    if (picture->width != series.camera.width || picture->height != series.camera.height)
        throwInvalid(file,
                     "This picture has " + sizeText(picture->width, picture->height) +
                         " pixels, and the camera “" + series.camera.name + "” " +
                         sizeText(series.camera.width, series.camera.height),
                     "Write the size that the camera was calibrated for, or scale the pictures to it.");
    return picture;
}

DataTable coverageTable(const ProjectedClip& projected)
{
    TableBuilder table("coverage", "How much of the texels that triangles cover some camera sees in each "
                                   "frame, and how many cameras see such a texel on average.");
    table.whole("frame", "frame").real("seen", "share").real("cameras");
    for (std::size_t f = 0; f < projected.frames.size(); ++f)
        table.add({static_cast<std::int64_t>(f), projected.frames[f].seen, projected.frames[f].cameras});
    return std::move(table).table();
}

DataTable cameraTable(const ProjectedClip& projected, const std::vector<CameraSeries>& cameras)
{
    TableBuilder table("cameras", "How many frames of the clip each camera has pictures of, and its share in "
                                  "the textures of all frames.");
    table.text("camera").whole("pictures", "frames").real("share");
    const auto frames = static_cast<std::int64_t>(projected.frames.size());
    double seen = 0;
    for (const FrameCoverage& frame : projected.frames)
        seen += frame.seen;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
        double share = 0;
        for (const FrameCoverage& frame : projected.frames)
            share += frame.seen * frame.shares[c];
        const auto pictures = std::ranges::count_if(cameras[c].pictures, [&](const auto& picture) {
            return picture.first >= 0 && picture.first < frames;
        });
        table.add({cameras[c].camera.name, static_cast<std::int64_t>(pictures), seen > 0 ? share / seen : 0});
    }
    return std::move(table).table();
}

DataArray timesSeen(ProjectedClip&& projected, const AtlasTexels& atlas)
{
    return {.name = "times-seen",
            .description = "Rows × columns of the textures, from the upper left: in how many frames some "
                           "camera sees each texel.",
            .unit = "frames",
            .shape = {atlas.height, atlas.width},
            .values = std::vector<std::int64_t>(projected.timesSeen.begin(), projected.timesSeen.end())};
}

/// Textures of frames that the clip does not have any more.
void ProjectionWork::removeOthers(const std::set<fs::path>& written) const
{
    std::error_code error;
    for (const auto& file : fs::directory_iterator(folder(), error)) {
        std::error_code ignored;
        if (!written.contains(file.path()))
            fs::remove(file.path(), ignored);
    }
}

Result ProjectionWork::compute(const StepContext& context, const Progress& progress) const
{
    const std::vector<CameraSeries> series = cameras();
    const MeshSequence clip = openClip(progress.part(0, 0.05));
    std::vector<PinholeCamera> calibrated;
    calibrated.reserve(series.size());
    for (const CameraSeries& each : series)
        calibrated.push_back(each.camera);
    const auto size = static_cast<int>(m_entry.size);
    const TextureProjector projector(clip.topology, calibrated, size, size, {.sharpness = m_entry.sharpness});
    fs::create_directories(folder());
    const auto fileOf = [&](FrameIndex frame) {
        return folder() / numberedName("####.png", frame.value, clip.frameCount());
    };
    ProjectedClip projected = projectClip(
        projector, clip,
        [&](std::size_t camera, FrameIndex frame) { return readPicture(series[camera], frame); },
        m_entry.fills, [&](FrameIndex frame, const Image& texture) { writeImage(texture, fileOf(frame)); },
        progress.part(0.05, 0.95));
    const auto unseen =
        std::ranges::count_if(projected.frames, [](const FrameCoverage& frame) { return frame.seen == 0; });
    if (unseen > 0)
        context.tell({.context = {.values = {{"text", "No camera sees the clip in " + std::to_string(unseen) +
                                                          " of its " + std::to_string(clip.frameCount()) +
                                                          " frames."}}}});
    Result result;
    std::set<fs::path> written;
    for (FrameIndex f(0); f.value < clip.frameCount(); ++f) {
        progress.part(0.95, 1).report(f.value, clip.frameCount());
        written.insert(fileOf(f));
        result.files.push_back(
            {storedPath(fileOf(f), m_opener->folder()), hashFile(fileOf(f), Progress(progress.token()))});
    }
    removeOthers(written);
    result.tables = {coverageTable(projected), cameraTable(projected, series)};
    result.arrays = {timesSeen(std::move(projected), projector.atlas())};
    return result;
}

} // namespace

std::vector<BuildStep> makeProjectionSteps(const StepMaking& making)
{
    std::vector<BuildStep> steps;
    for (const ProjectionEntry& entry : making.opener->project().projections) {
        const auto work = std::make_shared<const ProjectionWork>(making, entry);
        BuildStep step;
        step.name = clipStepOf(work->clipName());
        step.dataPrefix = work->clipName();
        step.character = work->character();
        step.settings = work->settings();
        step.files = [work](const Progress& progress) { return work->files(progress); };
        step.inputs = work->inputs();
        step.compute = [work](const StepContext& context, const Progress& progress) {
            return work->compute(context, progress);
        };
        steps.push_back(std::move(step));
    }
    return steps;
}

} // namespace quadrille
