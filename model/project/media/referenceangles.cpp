// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/referenceangles.h"

#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"

namespace quadrille {

namespace {

/// The sequence of which an entry is a clip; null where it is a file.
const SequenceEntry* clippedFrom(const Project& project, const SequenceEntry& entry)
{
    constexpr std::string_view section = "sequences/";
    const auto clip = clipOfSource(entry.source);
    return clip && clip->starts_with(section) ? findSequence(project, clip->substr(section.size())) : nullptr;
}

/// Frames and rate of what a sequence is cut from.
struct SourceTiming
{
    std::int64_t frameCount = 0;
    double fps = 0;
};

SourceTiming timingOf(SequenceOpener& opener, const SequenceEntry& entry, const Progress& progress)
{
    const Project& project = opener.project();
    if (const SequenceEntry* whole = clippedFrom(project, entry)) {
        const auto opened = opener.open(whole->name, progress);
        return {opened->sequence.frameCount(), opened->sequence.fps};
    }
    const MeshSequence source =
        openSource(entry, characterOf(project, entry), project.settings, opener.folder(), progress).sequence;
    return {source.frameCount(), source.fps};
}

} // namespace

std::filesystem::path referenceAnglesFile(const Project& project, const std::filesystem::path& folder,
                                          const SequenceEntry& entry)
{
    if (!entry.jointAngles.empty())
        return resolvePath(entry.jointAngles, folder);
    const SequenceEntry* source = clippedFrom(project, entry);
    return source ? referenceAnglesFile(project, folder, *source) : std::filesystem::path();
}

JointAngles referenceAngles(SequenceOpener& opener, const SequenceEntry& entry, const Progress& progress)
{
    const SourceTiming timing = timingOf(opener, entry, progress.part(0, 0.5));
    const auto file = referenceAnglesFile(opener.project(), opener.folder(), entry);
    JointAngles angles;
    if (entry.jointAngles.empty()) {
        angles = referenceAngles(opener, *clippedFrom(opener.project(), entry), progress.part(0.5, 1));
    } else {
        angles = jointAngles(readBvh(file));
        if (angles.frameCount == timing.frameCount)
            angles.fps = timing.fps;
    }
    const auto first = static_cast<double>(entry.range ? entry.range->first.value : 0);
    const auto opened = opener.open(entry.name, progress.part(0.5, 1));
    try {
        return resampled(angles, opened->sequence.fps, first * angles.fps / timing.fps,
                         opened->sequence.frameCount());
    } catch (const Error& error) {
        ErrorContext context = error.context();
        context.file = file;
        throw Error(error.code(), context);
    }
}

} // namespace quadrille
