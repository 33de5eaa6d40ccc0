// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What is under way for variations: their takes are aligned, their models learned, they are drawn.
#include "editor/documents/drawnresults.h"
#include "editor/documents/variationmediaitem.h"
#include "editor/jobs/jobrunner.h"

#include <QElapsedTimer>
#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

/// Between the states of learning that are shown.
constexpr int variationShowing = 150; // milliseconds

} // namespace

VariationJob VariationMedia::jobOf(const QString& name) const
{
    return {m_document.working(), name.toStdString()};
}

/// Nothing that is under way counts any more.
void VariationMedia::end(Item& item)
{
    item.run = ++m_runs;
    if (item.resultState.job)
        item.resultState.job->cancel();
    item.resultState.job.clear();
    item.resultState.error.reset();
}

template <typename Work, typename Done>
void VariationMedia::start(const QString& text, const QString& name, Item& item, Work work, Done done)
{
    const int run = item.run;
    item.resultState.job =
        m_jobs.start({.name = text,
                      .receiver = this,
                      .stillStands = [this, name, run] { return itemOf(name, run) != nullptr; },
                      .failed =
                          [this, name, run](const Error& error) {
                              ResultState& resultState = itemOf(name, run)->resultState;
                              resultState.state = State::Failed;
                              resultState.error = error;
                              emit changed(name);
                          }},
                     std::move(work), std::move(done));
    connect(item.resultState.job, &Job::ended, this, [this, name, run](Job::State state) {
        Item* ended = itemOf(name, run);
        if (state != Job::State::Cancelled || ended == nullptr)
            return;
        ended->resultState.state = ended->opened == nullptr    ? State::Idle
                                   : ended->learned == nullptr ? State::NotLearned
                                                               : State::Ready;
        emit changed(name);
    });
    emit changed(name);
}

void VariationMedia::open(const QString& name, Item& item, const VariationBasis& basis)
{
    end(item);
    item.basis = basis;
    item.resultState.state = State::Opening;
    start(
        tr("Aligning “%1”").arg(name), name, item,
        [job = jobOf(name)](const Progress& progress) {
            return std::make_shared<const OpenedVariation>(openVariation(job, progress));
        },
        [this, name, run = item.run](std::shared_ptr<const OpenedVariation> opened) {
            Item& done = *itemOf(name, run);
            done.opened = std::move(opened);
            done.resultState.movement = done.opened->movement;
            done.resultState.state = State::NotLearned;
            done.drawing.reset();
            done.resultState.drawn.reset();
            done.resultState.parts.clear();
            done.resultState.isStopped = false;
            done.learned.reset();
            const auto stopped = std::exchange(done.stopped, nullptr);
            if (const auto learned = done.opened->learned != nullptr ? done.opened->learned : stopped)
                takeLearned(name, run, learned);
            else
                emit changed(name);
        });
}

void VariationMedia::learn(const QString& name)
{
    if (m_delay.isActive())
        update();
    const auto found = m_items.find(name);
    if (found == m_items.end() || found->second->resultState.state == State::Opening)
        return;
    if (found->second->opened == nullptr) {
        retry(name);
        return;
    }
    Item& item = *found->second;
    end(item);
    item.resultState.state = State::Learning;
    item.resultState.isStopped = false;
    item.resultState.parts.clear();
    item.learned.reset();
    for (const BodyPart& part : item.resultState.movement->parts.parts)
        item.resultState.parts.push_back({.part = part.name});
    start(
        tr("Learning “%1”").arg(name), name, item,
        [job = jobOf(name), opened = item.opened, name, run = item.run,
         mailbox = m_mailbox](const Progress& progress) {
            QElapsedTimer sinceShown;
            const auto show = [&](const std::vector<PartProgress>& parts) {
                if (sinceShown.isValid() && sinceShown.elapsed() < variationShowing)
                    return;
                mailbox->postProgress(name, run, parts);
                sinceShown.start();
            };
            mailbox->postLearned(name, run, learnVariation(job, *opened, progress, show));
        },
        [] {});
}

void VariationMedia::takeLearned(const QString& name, int run,
                                 std::shared_ptr<const LearnedVariation> learned)
{
    Item* item = itemOf(name, run);
    if (item == nullptr)
        return;
    item->learned = std::move(learned);
    item->resultState.parts = item->learned->parts;
    item->resultState.isStopped = item->learned->isStopped();
    item->resultState.state = State::NotLearned;
    item->drawing.reset();
    if (item->learned == item->opened->learned && item->opened->drawn != nullptr) {
        item->resultState.drawn = item->opened->drawn;
        item->drawing = item->opened->drawing;
        item->resultState.state = State::Ready;
    }
    if (m_wanted.contains(name))
        update(name, *item);
    emit changed(name);
}

void VariationMedia::draw(const QString& name, Item& item)
{
    end(item);
    item.drawing = drawingOf(*m_document.variation(name));
    item.resultState.state = State::Drawing;
    start(
        tr("Drawing “%1”").arg(name), name, item,
        [job = jobOf(name), opened = item.opened, learned = item.learned](const Progress& progress) {
            return drawVariations(job, *opened, *learned, progress);
        },
        [this, name, run = item.run](std::shared_ptr<const std::vector<DrawnSet>> drawn) {
            Item& done = *itemOf(name, run);
            done.resultState.drawn = std::move(drawn);
            done.resultState.state = State::Ready;
            emit changed(name);
        });
}

void VariationMedia::stop(const QString& name)
{
    const auto found = m_items.find(name);
    if (found != m_items.end() && found->second->resultState.job)
        found->second->resultState.job->cancel();
}

} // namespace quadrille
