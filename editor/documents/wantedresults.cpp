// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/wantedresults.h"

#include <algorithm>

namespace quadrille {

void WantedResults::Post::operator()(std::function<void(const QString&, ResultState&)> take) const
{
    m_address.post([owner = m_owner, run = m_run, take = std::move(take)] {
        States::value_type* const found = owner->ofRun(run);
        if (found == nullptr)
            return;
        const QString name = found->first;
        take(name, *found->second);
        emit owner->changed(name);
    });
}

WantedResults::WantedResults(ProjectDocument& document, JobRunner& jobs, std::optional<Section> section,
                             std::chrono::milliseconds delay, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_section(section)
{
    m_delay.setSingleShot(true);
    m_delay.setInterval(delay);
    connect(&m_delay, &QTimer::timeout, this, &WantedResults::updateNow);
    connect(&document, &ProjectDocument::renamed, this, &WantedResults::rename);
    connect(&document, &ProjectDocument::changed, this, &WantedResults::take);
}

WantedResults::~WantedResults() = default;

ResultState* WantedResults::find(const QString& name) const
{
    const auto found = m_states.find(name);
    return found == m_states.end() ? nullptr : found->second.get();
}

WantedResults::States::value_type* WantedResults::ofRun(int run)
{
    const auto found =
        std::ranges::find_if(m_states, [run](const auto& each) { return each.second->run == run; });
    return found == m_states.end() ? nullptr : &*found;
}

void WantedResults::updateNow()
{
    m_delay.stop();
    update();
}

void WantedResults::setWanted(const QStringList& names)
{
    if (m_wanted == names)
        return;
    m_wanted = names;
    updateNow();
}

void WantedResults::take(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset)
        m_wanted.clear();
    follow(event);
}

void WantedResults::follow(const ChangeEvent& event)
{
    if (event.kind != ChangeEvent::Kind::File)
        updateSoon();
}

void WantedResults::rename(const ChangeEvent& event)
{
    if (event.entry.section != m_section)
        return;
    auto node = m_states.extract(event.before);
    if (!node.empty()) {
        node.key() = event.entry.name;
        m_states.insert(std::move(node));
    }
    std::ranges::replace(m_wanted, event.before, event.entry.name);
    renamed(event.before, event.entry.name);
}

void WantedResults::forget(const std::function<bool(const QString&, const ResultState&)>& isGone)
{
    QStringList gone;
    for (const auto& [name, state] : m_states) {
        if (isGone(name, *state))
            gone += name;
    }
    for (const QString& name : std::as_const(gone)) {
        end(*m_states.at(name));
        m_states.erase(name);
        emit changed(name);
    }
}

void WantedResults::stop(const QString& name)
{
    ResultState* const state = find(name);
    if (state == nullptr || !state->job || state->job->isOver())
        return;
    end(*state);
    stopped(name, *state);
    emit changed(name);
}

void WantedResults::end(ResultState& state)
{
    state.run = ++m_runs;
    if (state.job)
        state.job->cancel();
    state.job.clear();
    state.error.reset();
}

void WantedResults::stopped(const QString& /*name*/, ResultState& state)
{
    state.phase = ResultPhase::Idle;
}

JobSettings WantedResults::settingsOf(int run, const Shown& shown)
{
    return {.name = shown.text,
            .receiver = this,
            .stillStands = [this, run] { return ofRun(run) != nullptr; },
            .failed =
                [this, run](const Error& error) {
                    const auto& [name, state] = *ofRun(run);
                    state->phase = ResultPhase::Failed;
                    state->error = error;
                    emit changed(QString(name));
                },
            .background = shown.background};
}

void WantedResults::setJob(const QString& name, ResultState& state, Job* job)
{
    state.job = job;
    connect(job, &Job::ended, this, [this, run = state.run](Job::State how) {
        States::value_type* const ended = ofRun(run);
        if (how != Job::State::Cancelled || ended == nullptr)
            return;
        const QString current = ended->first;
        ended->second->job.clear();
        stopped(current, *ended->second);
        emit changed(current);
    });
    emit changed(name);
}

} // namespace quadrille

#include "moc_wantedresults.cpp"
