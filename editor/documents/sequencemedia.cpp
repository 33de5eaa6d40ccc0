// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/sequencemedia.h"

#include "editor/jobs/jobrunner.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/steps/resultsession.h"
#include "model/project/store/resultplaces.h"
#include "model/project/store/resultstore.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

SequenceMedia::SequenceMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs)
{
    connect(&document, &ProjectDocument::renamed, this, &SequenceMedia::rename);
    connect(&document, &ProjectDocument::changed, this, &SequenceMedia::follow);
    update();
}

SequenceMedia::~SequenceMedia() = default;

const SequenceMedia::ResultState* SequenceMedia::resultState(const QString& name) const
{
    const auto found = m_items.find(name);
    return found == m_items.end() ? nullptr : &found->second.resultState;
}

const MeshSequence* SequenceMedia::sequence(const QString& name) const
{
    const ResultState* found = resultState(name);
    return found != nullptr && found->sequence ? &*found->sequence : nullptr;
}

const MeshSequence* SequenceMedia::untrimmed(const QString& name) const
{
    const ResultState* found = resultState(name);
    return found != nullptr && found->untrimmed ? &*found->untrimmed : nullptr;
}

FrameRange SequenceMedia::usedFrames(const QString& name) const
{
    const auto found = m_items.find(name);
    if (found == m_items.end() || !found->second.resultState.untrimmed)
        return {};
    const ResultState& resultState = found->second.resultState;
    const FrameRange all = FrameRange::all(resultState.untrimmed->frameCount());
    if (!found->second.entry.range)
        return all;
    const double rate = resultState.untrimmed->fps / resultState.whole->fps;
    const auto place = [&](FrameIndex frame) {
        const auto moved = std::llround(static_cast<double>(frame.value) * rate);
        return FrameIndex(std::clamp<std::int64_t>(moved, 0, all.last.value));
    };
    return {place(found->second.entry.range->first), place(found->second.entry.range->last)};
}

std::optional<FrameRange> SequenceMedia::sourceRange(const QString& name, FrameRange used) const
{
    const ResultState* found = resultState(name);
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
    return std::ranges::any_of(
        m_items, [](const auto& item) { return item.second.resultState.state == State::Loading; });
}

void SequenceMedia::retry(const QString& name)
{
    const auto found = m_items.find(name);
    if (found != m_items.end() && found->second.resultState.state == State::Failed)
        open(name, found->second);
}

void SequenceMedia::rename(const ChangeEvent& event)
{
    if (event.entry.section != Section::Sequences)
        return;
    auto node = m_items.extract(event.before);
    if (node.empty())
        return;
    node.key() = event.entry.name;
    m_items.insert(std::move(node));
}

void SequenceMedia::follow(const ChangeEvent& event)
{
    if (event.touches(Section::Project))
        MediaCache::shared()->setBudget(m_document.project().settings.cacheBytes());
    if (event.kind == ChangeEvent::Kind::Reset) {
        for (auto& [name, item] : m_items) {
            if (item.job)
                item.job->cancel();
        }
        m_items.clear();
        update();
    } else if (event.entry.section != Section::Exports && event.entry.section != Section::Evaluations) {
        update();
    }
}

SequenceMedia::Source SequenceMedia::sourceOf(const SequenceEntry& entry) const
{
    Source source;
    source.entry.source = entry.source;
    source.entry.clip = entry.clip;
    source.entry.sourceFps = entry.sourceFps;
    source.entry.sourceAxes = entry.sourceAxes;
    source.entry.texture = entry.texture;
    if (const CharacterEntry* character = m_document.characterOf(entry)) {
        source.character.mesh = character->mesh;
        source.character.texture = character->texture;
    }
    if (const auto clip = clipOfSource(entry.source)) {
        source.entry.character = entry.character;
        source.parts = partsOfClip(m_document.project(), *clip);
        if (!source.parts->animations.empty() || !source.parts->variations.empty())
            source.results = cacheFolder(m_document.workingFile());
        const ResultStore store(source.results);
        const auto addClip = [&](const std::string& made) {
            for (const std::string& scene : clipStepsOf(*source.parts, made)) {
                std::error_code missing;
                source.computed.push_back(std::filesystem::last_write_time(store.fileOf(scene), missing));
            }
        };
        for (const AnimationEntry& animation : source.parts->animations)
            addClip("animations/" + animation.name);
        for (const VariationEntry& variation : source.parts->variations)
            addClip("variations/" + variation.name);
    }
    source.settings.fps = m_document.project().settings.fps;
    source.settings.axes = m_document.project().settings.axes;
    return source;
}

void SequenceMedia::update()
{
    std::map<QString, Item> kept;
    QStringList toOpen;
    QStringList toShape;
    for (const SequenceEntry& entry : m_document.project().sequences) {
        const QString name = QString::fromStdString(entry.name);
        const auto existing = m_items.find(name);
        Item item;
        const bool isNew = existing == m_items.end();
        if (!isNew)
            item = std::move(existing->second);
        Source source = sourceOf(entry);
        if (isNew || !(item.source == source))
            toOpen += name;
        else if (!(item.entry == entry))
            toShape += name;
        item.source = std::move(source);
        item.entry = entry;
        kept.insert_or_assign(name, std::move(item));
        if (!isNew)
            m_items.erase(existing);
    }
    for (auto& [name, item] : m_items) {
        if (item.job)
            item.job->cancel();
    }
    m_items = std::move(kept);
    for (const QString& name : toOpen)
        open(name, m_items.at(name));
    for (const QString& name : toShape) {
        shape(m_items.at(name));
        emit changed(name);
    }
}

std::shared_ptr<const OpenedSequence> SequenceMedia::openWhole(const Source& source,
                                                               const std::shared_ptr<SourceCache>& sources,
                                                               const Progress& progress)
{
    if (!source.parts)
        return sources->open(source.entry, &source.character, source.settings, {}, progress);
    Project project = *source.parts;
    project.sequences.push_back(source.entry);
    return SequenceOpener(std::move(project), {}, source.results, sources).open(source.entry.name, progress);
}

void SequenceMedia::open(const QString& name, Item& item)
{
    if (item.job)
        item.job->cancel();
    item.resultState = {};
    // The entry may be renamed while its job runs: it is found again by its source.
    const auto findItem = [this, source = item.source](const Job* job) {
        return std::ranges::find_if(m_items, [&](const auto& each) {
            return each.second.job == job && each.second.source == source;
        });
    };
    auto current = std::make_shared<QPointer<Job>>();
    item.job = m_jobs.start(
        {.name = tr("Opening “%1”").arg(name),
         .receiver = this,
         .stillStands = [this, findItem, current] { return findItem(*current) != m_items.end(); },
         .failed =
             [this, findItem, current](const Error& error) {
                 const auto found = findItem(*current);
                 found->second.resultState.state = State::Failed;
                 found->second.resultState.error = error;
                 emit changed(found->first);
             }},
        [source = item.source, sources = m_document.session().sources()](const Progress& progress) {
            return openWhole(source, sources, progress);
        },
        [this, findItem, current](std::shared_ptr<const OpenedSequence> opened) {
            const auto found = findItem(*current);
            found->second.resultState.whole = opened->sequence;
            found->second.resultState.issues = opened->issues;
            found->second.opened = std::move(opened);
            shape(found->second);
            emit changed(found->first);
        });
    *current = item.job;
    emit changed(name);
}

void SequenceMedia::shape(Item& item)
{
    ResultState& resultState = item.resultState;
    if (!resultState.whole)
        return;
    resultState.sequence.reset();
    resultState.error.reset();
    try {
        resultState.untrimmed = resampled(*resultState.whole, item.source.settings.fps);
        resultState.untrimmed->name = item.entry.name;
        MeshSequence sequence =
            item.entry.range ? resultState.whole->cutTo(*item.entry.range) : *resultState.whole;
        sequence = resampled(sequence, item.source.settings.fps);
        sequence.name = item.entry.name;
        sequence.labels = item.entry.labels;
        sequence.contacts = item.entry.contacts;
        resultState.sequence = std::move(sequence);
        resultState.state = State::Ready;
    } catch (const Error& error) {
        resultState.error = error;
        resultState.state = State::Failed;
    }
}

} // namespace quadrille
