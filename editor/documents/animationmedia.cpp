// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/animationmedia.h"

#include "editor/jobs/jobrunner.h"
#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"
#include "model/project/document/framenote.h"
#include "model/project/results/openanimation.h"
#include "model/project/results/projectresults.h"

#include <algorithm>
#include <mutex>
#include <utility>

namespace quadrille {

namespace {

constexpr int searchDelay = 20; // milliseconds
/// Between the walks that are shown while a better one is sought; making a clip holds the search up.
constexpr int searchShowing = 700; // milliseconds

/// Sound and camera make no other frames.
AnimationEntry withoutSoundAndCamera(AnimationEntry entry)
{
    setNotes(entry.unknown, {});
    entry.audio.reset();
    entry.camera.clear();
    return entry;
}

/// The variations that an animation draws from, with their body parts; empty where it has no such option.
Project drawnFrom(const Project& project, const AnimationEntry& entry)
{
    Project drawn;
    if (!entry.post.variations)
        return drawn;
    Project parts = partsOfClip(project, "animations/" + entry.name);
    drawn.variations = std::move(parts.variations);
    drawn.bodyParts = std::move(parts.bodyParts);
    return drawn;
}

} // namespace

/// Takes results from the threads that search to the interface, for as long as there is somebody to take
/// them.
struct AnimationMedia::Mailbox
{
    std::mutex mutex;
    AnimationMedia* owner = nullptr;

    void post(const QString& name, int search, AnimationResultPointer result)
    {
        const std::scoped_lock lock(mutex);
        if (owner != nullptr)
            QMetaObject::invokeMethod(
                owner,
                [owner = owner, name, search, result = std::move(result)] {
                    owner->take(name, search, result);
                },
                Qt::QueuedConnection);
    }
};

AnimationMedia::AnimationMedia(ProjectDocument& document, GraphMedia& graphs, JobRunner& jobs,
                               QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_graphs(graphs)
    , m_jobs(jobs)
    , m_mailbox(std::make_shared<Mailbox>())
{
    m_mailbox->owner = this;
    m_delay.setSingleShot(true);
    m_delay.setInterval(searchDelay);
    connect(&m_delay, &QTimer::timeout, this, qOverload<>(&AnimationMedia::update));
    connect(&document, &ProjectDocument::renamed, this, &AnimationMedia::rename);
    connect(&document, &ProjectDocument::changed, this, &AnimationMedia::follow);
    connect(&graphs, &GraphMedia::changed, this, [this] { m_delay.start(); });
}

AnimationMedia::~AnimationMedia()
{
    const std::scoped_lock lock(m_mailbox->mutex);
    m_mailbox->owner = nullptr;
}

void AnimationMedia::want(const QStringList& names)
{
    if (m_wanted == names)
        return;
    m_wanted = names;
    update();
}

const AnimationMedia::ResultState* AnimationMedia::resultState(const QString& name) const
{
    const auto found = m_items.find(name);
    return found == m_items.end() ? nullptr : &found->second.resultState;
}

std::shared_ptr<const AnimationResult> AnimationMedia::result(const QString& name) const
{
    const ResultState* found = resultState(name);
    return found == nullptr ? nullptr : found->result;
}

QString AnimationMedia::characterOf(const QString& name) const
{
    const AnimationEntry* entry = m_document.animation(name);
    return entry == nullptr ? QString()
                            : QString::fromStdString(characterNameOf(m_document.project(), *entry));
}

void AnimationMedia::retry(const QString& name)
{
    const auto found = m_items.find(name);
    if (found == m_items.end())
        return;
    found->second.isStopped = false;
    found->second.character.reset();
    update(name, found->second);
}

void AnimationMedia::stop(const QString& name)
{
    const auto found = m_items.find(name);
    if (found == m_items.end() || !found->second.resultState.job)
        return;
    found->second.isStopped = true;
    found->second.resultState.job->cancel();
    setIdle(name, found->second);
}

void AnimationMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_wanted.clear();
        update();
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Animations) {
        update();
    } else if (event.touches(Section::Animations) || event.touches(Section::Variations) ||
               event.touches(Section::BodyParts)) {
        m_delay.start();
    }
}

void AnimationMedia::rename(const ChangeEvent& event)
{
    if (event.entry.section != Section::Animations)
        return;
    std::ranges::replace(m_wanted, event.before, event.entry.name);
    auto node = m_items.extract(event.before);
    if (node.empty())
        return;
    // A search answers to the old name: another one makes the clip under the new one.
    if (node.mapped().resultState.job)
        node.mapped().resultState.job->cancel();
    node.mapped().character.reset();
    node.key() = event.entry.name;
    m_items.insert(std::move(node));
}

void AnimationMedia::update()
{
    m_delay.stop();
    for (auto it = m_items.begin(); it != m_items.end();) {
        if (m_wanted.contains(it->first) && m_document.animation(it->first) != nullptr) {
            ++it;
            continue;
        }
        if (it->second.resultState.job)
            it->second.resultState.job->cancel();
        const QString gone = it->first;
        it = m_items.erase(it);
        emit changed(gone);
    }
    for (const QString& name : std::as_const(m_wanted)) {
        if (m_document.animation(name) != nullptr)
            update(name, m_items[name]);
    }
}

void AnimationMedia::update(const QString& name, Item& item)
{
    const AnimationEntry entry = withoutSoundAndCamera(*m_document.animation(name));
    if (!entry.asksForSomething()) {
        item.solved = entry;
        item.resultState.result.reset();
        setIdle(name, item);
        return;
    }
    const QString character = characterOf(name);
    const GraphMedia::ResultState* graph = m_graphs.resultState(character);
    if (graph == nullptr || graph->state != GraphMedia::State::Ready) {
        if (item.resultState.job)
            item.resultState.job->cancel();
        item.resultState.job.clear();
        item.resultState.error = graph == nullptr ? std::nullopt : graph->error;
        item.resultState.state = item.resultState.error ? State::Failed : State::Waiting;
        item.character.reset();
        if (graph != nullptr && graph->state != GraphMedia::State::Failed)
            m_graphs.ask(character);
        emit changed(name);
        return;
    }
    Project drawn = drawnFrom(m_document.project(), entry);
    if (item.character == graph->opened && item.solved == entry && item.drawnFrom == drawn)
        return;
    item.isStopped = false;
    item.character = graph->opened;
    item.drawnFrom = std::move(drawn);
    solve(name, item, entry);
}

void AnimationMedia::solve(const QString& name, Item& item, const AnimationEntry& entry)
{
    if (item.resultState.job)
        item.resultState.job->cancel();
    item.solved = entry;
    item.search = ++m_searches;
    item.resultState.state = State::Solving;
    item.resultState.error.reset();
    constexpr double pause = 0.001 * searchShowing;
    const auto work = [working = m_document.working(), mailbox = m_mailbox, name,
                       search = item.search](const Progress& progress) {
        const auto show = [&](AnimationResultPointer better) {
            mailbox->post(name, search, std::move(better));
        };
        return openAnimation(working, name.toStdString(), progress, show, pause);
    };
    item.resultState.job =
        m_jobs.start({.name = tr("Animation “%1”").arg(name),
                      .receiver = this,
                      .stillStands =
                          [this, name, search = item.search] {
                              const auto found = m_items.find(name);
                              return found != m_items.end() && found->second.search == search;
                          },
                      .failed =
                          [this, name](const Error& error) {
                              ResultState& resultState = m_items.at(name).resultState;
                              resultState.state = State::Failed;
                              resultState.error = error;
                              emit changed(name);
                          }},
                     work, [this, name, search = item.search](AnimationResultPointer result) {
                         take(name, search, std::move(result));
                     });
    connect(item.resultState.job, &Job::ended, this, [this, name, search = item.search](Job::State state) {
        const auto found = m_items.find(name);
        if (state != Job::State::Cancelled || found == m_items.end() || found->second.search != search)
            return;
        found->second.isStopped = true;
        setIdle(name, found->second);
    });
    emit changed(name);
}

void AnimationMedia::take(const QString& name, int search, AnimationResultPointer result)
{
    const auto found = m_items.find(name);
    if (found == m_items.end() || found->second.search != search || found->second.isStopped)
        return;
    ResultState& resultState = found->second.resultState;
    if (resultState.result != nullptr && resultState.state == State::Ready && !result->isFinal)
        return;
    if (result->isFinal)
        resultState.state = State::Ready;
    resultState.result = std::move(result);
    emit changed(name);
}

void AnimationMedia::setIdle(const QString& name, Item& item)
{
    if (item.resultState.job && !item.isStopped)
        item.resultState.job->cancel();
    item.resultState.job.clear();
    item.resultState.error.reset();
    item.resultState.state = State::Idle;
    emit changed(name);
}

} // namespace quadrille
