// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/sequencemedia.h"

#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/results/projectresults.h"
#include "model/project/steps/resultsession.h"
#include "model/project/store/appearanceresult.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

SequenceMedia::SequenceMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, Section::Sequences, {}, parent)
{
    SequenceMedia::update();
}

SequenceMedia::~SequenceMedia() = default;

const MeshSequence* SequenceMedia::sequence(const QString& name) const
{
    const State* found = resultState(name);
    return found != nullptr && found->sequence ? &*found->sequence : nullptr;
}

const MeshSequence* SequenceMedia::untrimmed(const QString& name) const
{
    const State* found = resultState(name);
    return found != nullptr && found->untrimmed ? &*found->untrimmed : nullptr;
}

FrameRange SequenceMedia::usedFrames(const QString& name) const
{
    const Item* const found = find<const Item>(name);
    if (found == nullptr || !found->untrimmed)
        return {};
    const FrameRange all = FrameRange::all(found->untrimmed->frameCount());
    if (!found->entry.range)
        return all;
    const double rate = found->untrimmed->fps / found->whole->fps;
    const auto place = [&](FrameIndex frame) {
        const auto moved = std::llround(static_cast<double>(frame.value) * rate);
        return FrameIndex(std::clamp<std::int64_t>(moved, 0, all.last.value));
    };
    return {place(found->entry.range->first), place(found->entry.range->last)};
}

std::optional<FrameRange> SequenceMedia::sourceRange(const QString& name, FrameRange used) const
{
    const State* found = resultState(name);
    if (found == nullptr || !found->untrimmed || used == FrameRange::all(found->untrimmed->frameCount()))
        return std::nullopt;
    const double rate = found->whole->fps / found->untrimmed->fps;
    const auto place = [&](FrameIndex frame) {
        const auto moved = std::llround(static_cast<double>(frame.value) * rate);
        return FrameIndex(std::clamp<std::int64_t>(moved, 0, found->whole->frameCount() - 1));
    };
    return FrameRange{place(used.first), place(used.last)};
}

bool SequenceMedia::isLoading() const
{
    return std::ranges::any_of(states(),
                               [](const auto& each) { return each.second->phase == ResultPhase::Computing; });
}

void SequenceMedia::retry(const QString& name)
{
    Item* const item = find<Item>(name);
    if (item != nullptr && item->phase == ResultPhase::Failed)
        open(name, *item);
}

void SequenceMedia::follow(const ChangeEvent& event)
{
    if (event.touches(Section::Project))
        MediaCache::shared()->setBudget(document().project().settings.cacheBytes());
    const bool isOther = event.kind == ChangeEvent::Kind::Reset;
    if (isOther) {
        for (const auto& [name, state] : states())
            static_cast<Item&>(*state).source.reset();
    }
    if (isOther || (event.entry.section != Section::Exports && event.entry.section != Section::Evaluations))
        updateNow();
}

SequenceMedia::Source SequenceMedia::sourceOf(const SequenceEntry& entry) const
{
    Source source;
    source.entry.source = entry.source;
    source.entry.clip = entry.clip;
    source.entry.sourceFps = entry.sourceFps;
    source.entry.sourceAxes = entry.sourceAxes;
    source.entry.texture = entry.texture;
    if (const CharacterEntry* character = document().characterOf(entry)) {
        source.character.mesh = character->mesh;
        source.character.texture = character->texture;
    }
    if (const auto clip = clipOfSource(entry.source)) {
        source.entry.character = entry.character;
        source.parts = partsOfClip(document().project(), *clip);
        if (!source.parts->animations.empty() || !source.parts->variations.empty() ||
            !source.parts->lives.empty() || !source.parts->transfers.empty() ||
            !source.parts->projections.empty())
            source.results = cacheFolder(document().workingFile());
        const ResultStore store(source.results);
        const auto addTime = [&](const std::string& step) {
            std::error_code missing;
            source.computed.push_back(std::filesystem::last_write_time(store.fileOf(step), missing));
        };
        const auto addClip = [&](const std::string& made) {
            for (const std::string& scene : clipStepsOf(*source.parts, made))
                addTime(scene);
        };
        for (const AnimationEntry& animation : source.parts->animations)
            addClip("animations/" + animation.name);
        for (const VariationEntry& variation : source.parts->variations)
            addClip("variations/" + variation.name);
        for (const LiveEntry& live : source.parts->lives)
            addClip("live/" + live.name);
        for (const TransferEntry& transfer : source.parts->transfers)
            addClip("transfers/" + transfer.name);
        for (const ProjectionEntry& projection : source.parts->projections)
            addClip("projections/" + projection.name);
        // Frames between captured ones have textures of a model, whatever that is made of.
        for (const AppearanceEntry& appearance : document().project().appearances) {
            AppearanceEntry& known = source.parts->appearances.emplace_back();
            known.name = appearance.name;
            known.character = appearance.character;
            known.varied = appearance.varied;
            for (const CompletionEntry& completion : appearance.completions)
                known.completions.emplace_back().frame = completion.frame;
            addTime(appearanceModelStep(appearance.name));
            addTime(appearanceCompletionsStep(appearance.name));
            addTime(appearancePosesStep(appearance.name));
        }
        source.folder = document().workingFile().parent_path();
    }
    source.settings.fps = document().project().settings.fps;
    source.settings.axes = document().project().settings.axes;
    return source;
}

void SequenceMedia::update()
{
    // Slots may ask for any of them: all are as the project says before somebody hears of one.
    QStringList toOpen;
    QStringList toShape;
    for (const SequenceEntry& entry : document().project().sequences) {
        const QString name = QString::fromStdString(entry.name);
        Item& item = make<Item>(name);
        Source source = sourceOf(entry);
        if (item.source != source)
            toOpen += name;
        else if (item.entry != entry)
            toShape += name;
        item.source = std::move(source);
        item.entry = entry;
    }
    for (const QString& name : std::as_const(toOpen))
        open(name, *find<Item>(name));
    for (const QString& name : std::as_const(toShape)) {
        shape(*find<Item>(name));
        emit changed(name);
    }
    forget([this](const QString& name, const ResultState& /*state*/) {
        return document().sequence(name) == nullptr;
    });
}

std::shared_ptr<const OpenedSequence> SequenceMedia::openWhole(const Source& source,
                                                               const std::shared_ptr<SourceCache>& sources,
                                                               const Progress& progress)
{
    if (!source.parts)
        return sources->open(source.entry, &source.character, source.settings, {}, progress);
    Project project = *source.parts;
    project.sequences.push_back(source.entry);
    return SequenceOpener(std::move(project), source.folder, source.results, sources)
        .open(source.entry.name, progress);
}

void SequenceMedia::open(const QString& name, Item& item)
{
    item.phase = ResultPhase::Computing;
    item.whole.reset();
    item.untrimmed.reset();
    item.sequence.reset();
    item.issues.clear();
    // Nobody else brings the clips of performances up to date.
    std::optional<WorkingProject> performed;
    if (item.source->parts && !item.source->parts->lives.empty())
        performed = document().working();
    start(
        name, item, {.text = tr("Opening “%1”").arg(name)},
        [source = *item.source, sources = document().session().sources(), performed](const Progress& progress,
                                                                                     const Post& /*post*/) {
            if (performed)
                ProjectResults(*performed)
                    .get(clipStepsOf(*source.parts, *clipOfSource(source.entry.source)),
                         progress.part(0, 0.9));
            return openWhole(source, sources, progress);
        },
        [this](const QString& current, std::shared_ptr<const OpenedSequence> opened) {
            Item& done = *find<Item>(current);
            if (done.source->parts && !done.source->parts->lives.empty())
                done.source = sourceOf(done.entry); // its clip was computed just now
            done.whole = opened->sequence;
            done.issues = opened->issues;
            done.opened = std::move(opened);
            shape(done);
        });
}

void SequenceMedia::stopped(const QString& /*name*/, ResultState& state)
{
    state.phase = ResultPhase::Failed;
    state.error = Error(ErrorCode::Cancelled);
}

void SequenceMedia::shape(Item& item)
{
    if (!item.whole)
        return;
    item.sequence.reset();
    item.error.reset();
    try {
        const double fps = item.source->settings.fps;
        item.untrimmed = resampled(*item.whole, fps);
        item.untrimmed->name = item.entry.name;
        MeshSequence sequence = item.entry.range ? item.whole->cutTo(*item.entry.range) : *item.whole;
        sequence = resampled(sequence, fps);
        sequence.name = item.entry.name;
        sequence.labels = item.entry.labels;
        sequence.contacts = item.entry.contacts;
        item.sequence = std::move(sequence);
        item.phase = ResultPhase::Ready;
    } catch (const Error& error) {
        item.error = error;
        item.phase = ResultPhase::Failed;
    }
}

} // namespace quadrille

#include "moc_sequencemedia.cpp"
