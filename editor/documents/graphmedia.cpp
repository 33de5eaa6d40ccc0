// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/graphmedia.h"

#include "editor/jobs/jobrunner.h"
#include "model/project/document/madeclips.h"
#include "model/project/results/opencharacter.h"
#include "model/project/steps/charactersteps.h"

#include <utility>

namespace quadrille {

namespace {

constexpr int graphDelay = 150; // milliseconds

} // namespace

GraphMedia::GraphMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs)
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(graphDelay);
    connect(&m_delay, &QTimer::timeout, this, &GraphMedia::update);
    connect(&document, &ProjectDocument::changed, this, &GraphMedia::follow);
    update();
}

GraphMedia::~GraphMedia() = default;

const GraphMedia::Medium* GraphMedia::medium(const QString& character) const
{
    const auto found = m_items.find(character);
    return found == m_items.end() ? nullptr : &found->second.medium;
}

QStringList GraphMedia::characters() const
{
    const Project& project = m_document.project();
    QStringList names;
    for (const CharacterEntry& character : project.characters) {
        if (!sequencesOfGraph(project, character.name).empty())
            names += QString::fromStdString(character.name);
    }
    if (project.characters.empty() && !project.sequences.empty())
        names += QString();
    return names;
}

QString GraphMedia::firstCharacter() const
{
    return characters().value(0);
}

void GraphMedia::ask(const QString& character)
{
    if (m_delay.isActive())
        update();
    const auto found = m_items.find(character);
    if (found == m_items.end())
        return;
    Item& item = found->second;
    const bool isOnlyOpening = item.medium.state == State::Computing && !item.isWanted;
    item.isWanted = true;
    if (item.medium.state == State::Missing || item.medium.state == State::Failed || isOnlyOpening)
        open(character, item);
}

void GraphMedia::cancel(const QString& character)
{
    const auto found = m_items.find(character);
    if (found == m_items.end() || !found->second.medium.job)
        return;
    found->second.medium.job->cancel();
    forget(character, found->second);
}

void GraphMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        for (const auto& [character, item] : m_items) {
            if (item.medium.job)
                item.medium.job->cancel();
        }
        const auto before = std::exchange(m_items, {});
        for (const auto& [character, item] : before)
            emit changed(character);
        update();
    } else if (event.kind != ChangeEvent::Kind::File) {
        m_delay.start();
    }
}

void GraphMedia::update()
{
    m_delay.stop();
    const QStringList wanted = characters();
    for (auto it = m_items.begin(); it != m_items.end();) {
        if (wanted.contains(it->first)) {
            ++it;
            continue;
        }
        if (it->second.medium.job)
            it->second.medium.job->cancel();
        const QString gone = it->first;
        it = m_items.erase(it);
        emit changed(gone);
    }
    for (const QString& character : wanted) {
        Source source = sourceOf(character);
        const auto [it, isNew] = m_items.try_emplace(character);
        if (!isNew && it->second.source == source)
            continue;
        it->second.source = std::move(source);
        open(character, it->second);
    }
}

GraphMedia::Source GraphMedia::sourceOf(const QString& character) const
{
    const Project& project = m_document.project();
    Source source{.graph = graphOf(project, character.toStdString()),
                  .settings = project.settings,
                  .characters = project.characters,
                  .sequences = project.sequences,
                  .animations = {},
                  .bodyParts = {},
                  .variations = {}};
    for (const SequenceEntry& sequence : project.sequences) {
        if (shownClip(project, sequence)) {
            source.animations = project.animations;
            source.bodyParts = project.bodyParts;
            source.variations = project.variations;
        }
    }
    return source;
}

void GraphMedia::open(const QString& character, Item& item)
{
    if (item.medium.job)
        item.medium.job->cancel();
    item.medium.state = State::Computing;
    item.medium.error.reset();
    const auto isCurrent = [this, character, source = item.source, wanted = item.isWanted] {
        const auto found = m_items.find(character);
        return found != m_items.end() && found->second.source == source && found->second.isWanted == wanted;
    };
    const auto opening = item.isWanted ? GraphOpening::Compute : GraphOpening::IfFresh;
    item.medium.job = m_jobs.start(
        {.name = character.isEmpty() ? tr("Graph") : tr("Graph of “%1”").arg(character),
         .receiver = this,
         .stillStands = isCurrent,
         .failed =
             [this, character](const Error& error) {
                 Medium& medium = m_items.at(character).medium;
                 medium.state = State::Failed;
                 medium.error = error;
                 emit changed(character);
             },
         .background = !item.isWanted},
        [working = m_document.working(), character, opening](const Progress& progress) {
            return openCharacter(working, character.toStdString(), opening, progress);
        },
        [this, character](std::shared_ptr<const OpenedCharacter> opened) {
            Item& done = m_items.at(character);
            done.medium.state = opened == nullptr ? State::Missing : State::Ready;
            if (opened != nullptr) {
                done.isWanted = true;
                done.medium.opened = std::move(opened);
            }
            emit changed(character);
        });
    connect(item.medium.job, &Job::ended, this, [this, character, job = item.medium.job](Job::State state) {
        const auto found = m_items.find(character);
        if (state == Job::State::Cancelled && found != m_items.end() && found->second.medium.job == job)
            forget(character, found->second);
    });
    emit changed(character);
}

void GraphMedia::forget(const QString& character, Item& item)
{
    item.isWanted = false;
    item.medium.job.clear();
    item.medium.state = State::Missing;
    emit changed(character);
}

} // namespace quadrille
