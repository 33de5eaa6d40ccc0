// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationmedia.h"

#include "editor/documents/variationbasis.h"
#include "editor/documents/variationwork.h"
#include "editor/jobs/jobrunner.h"

#include <QElapsedTimer>
#include <algorithm>
#include <mutex>
#include <utility>

namespace quadrille {

namespace {

constexpr int delayMilliseconds = 200;
/// Between the states of learning that are shown.
constexpr int showingMilliseconds = 150;

} // namespace

struct VariationMedia::Item
{
    Medium medium;
    std::optional<VariationBasis> basis; ///< of `opened` and `learned`
    std::shared_ptr<const OpenedVariation> opened;
    std::shared_ptr<const LearnedVariation> learned; ///< null before learning
    std::shared_ptr<const LearnedVariation> stopped; ///< to go on with where there is nothing better
    std::optional<VariationDrawing> drawing;         ///< of `drawn`
    int run = 0;                                     ///< counts work, so that late results are known
};

/// Takes states of learning from its thread to the interface, for as long as there is somebody to take them.
struct VariationMedia::Mailbox
{
    std::mutex mutex;
    VariationMedia* owner = nullptr;

    void postProgress(const QString& name, int run, std::vector<PartProgress> parts)
    {
        post([this, name, run, parts = std::move(parts)]() mutable {
            Item* item = owner->itemOf(name, run);
            if (item == nullptr || item->medium.state != State::Learning)
                return;
            item->medium.parts = std::move(parts);
            emit owner->changed(name);
        });
    }
    void postLearned(const QString& name, int run, std::shared_ptr<const LearnedVariation> learned)
    {
        post([this, name, run, learned = std::move(learned)] { owner->takeLearned(name, run, learned); });
    }

private:
    template <typename Take>
    void post(Take take)
    {
        const std::scoped_lock lock(mutex);
        if (owner != nullptr)
            QMetaObject::invokeMethod(owner, std::move(take), Qt::QueuedConnection);
    }
};

VariationMedia::VariationMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_mailbox(std::make_shared<Mailbox>())
{
    m_mailbox->owner = this;
    m_delay.setSingleShot(true);
    m_delay.setInterval(delayMilliseconds);
    connect(&m_delay, &QTimer::timeout, this, qOverload<>(&VariationMedia::update));
    connect(&document, &ProjectDocument::changed, this, &VariationMedia::follow);
}

VariationMedia::~VariationMedia()
{
    const std::scoped_lock lock(m_mailbox->mutex);
    m_mailbox->owner = nullptr;
}

void VariationMedia::want(const QStringList& names)
{
    if (m_wanted == names)
        return;
    m_wanted = names;
    update();
}

const VariationMedia::Medium* VariationMedia::medium(const QString& name) const
{
    const auto found = m_items.find(name);
    return found == m_items.end() ? nullptr : &found->second->medium;
}

const MeshSequence* VariationMedia::clip(const QString& name, int number) const
{
    const Medium* found = medium(name);
    if (found == nullptr || found->drawn == nullptr)
        return nullptr;
    for (const DrawnSet& set : *found->drawn) {
        const auto drawn = std::ranges::find(set.variations, number, &DrawnVariation::number);
        if (drawn != set.variations.end())
            return drawn->sequence.source == nullptr ? nullptr : &drawn->sequence;
    }
    return nullptr;
}

VariationMedia::Item* VariationMedia::itemOf(const QString& name, int run)
{
    const auto found = m_items.find(name);
    return found != m_items.end() && found->second->run == run ? found->second.get() : nullptr;
}

void VariationMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_wanted.clear();
        update();
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Variations) {
        std::ranges::replace(m_wanted, event.before, event.entry.name);
        update();
    } else if (event.kind != ChangeEvent::Kind::File) {
        m_delay.start();
    }
}

void VariationMedia::update()
{
    m_delay.stop();
    for (auto it = m_items.begin(); it != m_items.end();) {
        if (m_wanted.contains(it->first) && m_document.variation(it->first) != nullptr) {
            ++it;
            continue;
        }
        if (it->second->medium.job)
            it->second->medium.job->cancel();
        const QString gone = it->first;
        it = m_items.erase(it);
        emit changed(gone);
    }
    for (const QString& name : std::as_const(m_wanted)) {
        if (m_document.variation(name) == nullptr)
            continue;
        std::unique_ptr<Item>& item = m_items[name];
        if (item == nullptr)
            item = std::make_unique<Item>();
        update(name, *item);
    }
}

/// Does what is to be done next, one thing after the other.
void VariationMedia::update(const QString& name, Item& item)
{
    const VariationEntry& entry = *m_document.variation(name);
    const VariationBasis basis = basisOf(m_document.project(), entry);
    if (entry.training.empty()) {
        end(item);
        item = Item{};
        emit changed(name);
        return;
    }
    if (item.basis != basis) {
        open(name, item, basis);
        return;
    }
    if (item.learned != nullptr && item.drawing != drawingOf(entry))
        draw(name, item);
}

VariationJob VariationMedia::jobOf(const QString& name) const
{
    return {m_document.snapshot(), m_document.workingFile(), name.toStdString()};
}

/// Nothing that is under way counts any more.
void VariationMedia::end(Item& item)
{
    item.run = ++m_runs;
    if (item.medium.job)
        item.medium.job->cancel();
    item.medium.job.clear();
    item.medium.error.reset();
}

template <typename Work, typename Done>
void VariationMedia::start(const QString& text, const QString& name, Item& item, Work work, Done done)
{
    const int run = item.run;
    item.medium.job = m_jobs.start({.name = text,
                                    .receiver = this,
                                    .stillStands = [this, name, run] { return itemOf(name, run) != nullptr; },
                                    .failed =
                                        [this, name, run](const Error& error) {
                                            Medium& medium = itemOf(name, run)->medium;
                                            medium.state = State::Failed;
                                            medium.error = error;
                                            emit changed(name);
                                        }},
                                   std::move(work), std::move(done));
    connect(item.medium.job, &Job::ended, this, [this, name, run](Job::State state) {
        Item* ended = itemOf(name, run);
        if (state != Job::State::Cancelled || ended == nullptr)
            return;
        ended->medium.state = ended->opened == nullptr    ? State::Idle
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
    item.medium.state = State::Opening;
    start(
        tr("Aligning “%1”").arg(name), name, item,
        [job = jobOf(name)](const Progress& progress) {
            return std::make_shared<const OpenedVariation>(openVariation(job, progress));
        },
        [this, name, run = item.run](std::shared_ptr<const OpenedVariation> opened) {
            Item& done = *itemOf(name, run);
            done.opened = std::move(opened);
            done.medium.movement = done.opened->movement;
            done.medium.state = State::NotLearned;
            done.drawing.reset();
            done.medium.drawn.reset();
            done.medium.parts.clear();
            done.medium.isStopped = false;
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
    if (found == m_items.end() || found->second->medium.state == State::Opening)
        return;
    if (found->second->opened == nullptr) {
        retry(name);
        return;
    }
    Item& item = *found->second;
    end(item);
    item.medium.state = State::Learning;
    item.medium.isStopped = false;
    item.medium.parts.clear();
    item.learned.reset();
    for (const BodyPart& part : item.medium.movement->parts.parts)
        item.medium.parts.push_back({.part = part.name});
    start(
        tr("Learning “%1”").arg(name), name, item,
        [job = jobOf(name), opened = item.opened, name, run = item.run, mailbox = m_mailbox,
         parts = item.medium.parts](const Progress& progress) mutable {
            QElapsedTimer sinceShown;
            const PartWatch watch = [&](std::size_t part, int /*iteration*/, double objective,
                                        const GpdmState& state) {
                parts[part].objective.push_back(objective);
                parts[part].state = state;
                if (sinceShown.isValid() && sinceShown.elapsed() < showingMilliseconds)
                    return;
                mailbox->postProgress(name, run, parts);
                sinceShown.start();
            };
            mailbox->postLearned(name, run, learnVariation(job, *opened, progress, watch));
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
    item->medium.parts = item->learned->parts;
    item->medium.isStopped = std::ranges::any_of(
        item->medium.parts, [](const PartProgress& part) { return part.stop == GpdmStop::Cancelled; });
    item->medium.state = State::NotLearned;
    item->drawing.reset();
    update(name, *item);
    emit changed(name);
}

void VariationMedia::draw(const QString& name, Item& item)
{
    end(item);
    item.drawing = drawingOf(*m_document.variation(name));
    item.medium.state = State::Drawing;
    start(
        tr("Drawing “%1”").arg(name), name, item,
        [job = jobOf(name), opened = item.opened, learned = item.learned](const Progress& progress) {
            return drawVariations(job, *opened, *learned, progress);
        },
        [this, name, run = item.run](std::vector<DrawnSet> drawn) {
            Medium& medium = itemOf(name, run)->medium;
            medium.drawn = std::make_shared<const std::vector<DrawnSet>>(std::move(drawn));
            medium.state = State::Ready;
            emit changed(name);
        });
}

void VariationMedia::stop(const QString& name)
{
    const auto found = m_items.find(name);
    if (found != m_items.end() && found->second->medium.job)
        found->second->medium.job->cancel();
}

void VariationMedia::readStopped()
{
    for (const auto& [name, item] : m_items) {
        const VariationEntry* entry = m_document.variation(name);
        if (!item->medium.isStopped || entry == nullptr ||
            item->basis != basisOf(m_document.project(), *entry))
            continue;
        item->stopped = item->learned;
        retry(name);
    }
}

void VariationMedia::retry(const QString& name)
{
    const auto found = m_items.find(name);
    if (found == m_items.end())
        return;
    found->second->basis.reset();
    update(name, *found->second);
}

} // namespace quadrille
