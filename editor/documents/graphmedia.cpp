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

const GraphMedia::ResultState* GraphMedia::resultState(const QString& character) const
{
    const auto found = m_items.find(character);
    return found == m_items.end() ? nullptr : &found->second.resultState;
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
    const bool isOnlyOpening = item.resultState.state == State::Computing && !item.isWanted;
    item.isWanted = true;
    if (item.resultState.state == State::Missing || item.resultState.state == State::Failed || isOnlyOpening)
        open(character, item);
}

void GraphMedia::cancel(const QString& character)
{
    const auto found = m_items.find(character);
    if (found == m_items.end() || !found->second.resultState.job)
        return;
    found->second.resultState.job->cancel();
    forget(character, found->second);
}

void GraphMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        for (const auto& [character, item] : m_items) {
            if (item.resultState.job)
                item.resultState.job->cancel();
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
        if (it->second.resultState.job)
            it->second.resultState.job->cancel();
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
    if (item.resultState.job)
        item.resultState.job->cancel();
    item.resultState.state = State::Computing;
    item.resultState.error.reset();
    const auto isCurrent = [this, character, source = item.source, wanted = item.isWanted] {
        const auto found = m_items.find(character);
        return found != m_items.end() && found->second.source == source && found->second.isWanted == wanted;
    };
    const auto opening = item.isWanted ? GraphOpening::Compute : GraphOpening::IfFresh;
    item.resultState.job = m_jobs.start(
        {.name = character.isEmpty() ? tr("Graph") : tr("Graph of “%1”").arg(character),
         .receiver = this,
         .stillStands = isCurrent,
         .failed =
             [this, character](const Error& error) {
                 ResultState& resultState = m_items.at(character).resultState;
                 resultState.state = State::Failed;
                 resultState.error = error;
                 emit changed(character);
             },
         .background = !item.isWanted},
        [working = m_document.working(), character, opening](const Progress& progress) {
            return openCharacter(working, character.toStdString(), opening, progress);
        },
        [this, character](std::shared_ptr<const OpenedCharacter> opened) {
            Item& done = m_items.at(character);
            done.resultState.state = opened == nullptr ? State::Missing : State::Ready;
            if (opened != nullptr) {
                done.isWanted = true;
                done.resultState.opened = std::move(opened);
            }
            emit changed(character);
        });
    connect(item.resultState.job, &Job::ended, this,
            [this, character, job = item.resultState.job](Job::State state) {
                const auto found = m_items.find(character);
                if (state == Job::State::Cancelled && found != m_items.end() &&
                    found->second.resultState.job == job)
                    forget(character, found->second);
            });
    emit changed(character);
}

void GraphMedia::forget(const QString& character, Item& item)
{
    item.isWanted = false;
    item.resultState.job.clear();
    item.resultState.state = State::Missing;
    emit changed(character);
}

} // namespace quadrille
