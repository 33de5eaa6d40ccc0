// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationmedia.h"

#include "editor/documents/variationmediaitem.h"
#include "editor/jobs/jobrunner.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

namespace quadrille {

namespace {

constexpr int variationDelay = 200; // milliseconds
/// Variations that nobody looks at now and that are kept all the same.
constexpr std::ptrdiff_t mostKept = 3;

} // namespace

VariationMedia::VariationMedia(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs), m_mailbox(std::make_shared<Mailbox>())
{
    m_mailbox->owner = this;
    m_delay.setSingleShot(true);
    m_delay.setInterval(variationDelay);
    connect(&m_delay, &QTimer::timeout, this, qOverload<>(&VariationMedia::update));
    connect(&document, &ProjectDocument::renamed, this, &VariationMedia::rename);
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

const VariationMedia::ResultState* VariationMedia::resultState(const QString& name) const
{
    const auto found = m_items.find(name);
    return found == m_items.end() ? nullptr : &found->second->resultState;
}

const MeshSequence* VariationMedia::clip(const QString& name, int number) const
{
    const ResultState* found = resultState(name);
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

void VariationMedia::rename(const ChangeEvent& event)
{
    if (event.entry.section != Section::Variations)
        return;
    std::ranges::replace(m_wanted, event.before, event.entry.name);
    auto node = m_items.extract(event.before);
    if (node.empty())
        return;
    Item& item = *node.mapped();
    if (item.resultState.job) {
        // It would answer to the old name.
        end(item);
        item.basis.reset();
    }
    if (item.basis)
        item.basis->entry.name = event.entry.name.toStdString();
    node.key() = event.entry.name;
    m_items.insert(std::move(node));
}

void VariationMedia::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        m_wanted.clear();
        // What was kept is of another project.
        for (const auto& [name, item] : m_items)
            item->wantedAt = -1;
        update();
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Variations) {
        update();
    } else if (event.kind != ChangeEvent::Kind::File) {
        m_delay.start();
    }
}

void VariationMedia::update()
{
    m_delay.stop();
    Item::forget(*this);
    for (const QString& name : std::as_const(m_wanted)) {
        if (m_document.variation(name) == nullptr)
            continue;
        std::unique_ptr<Item>& item = m_items[name];
        if (item == nullptr)
            item = std::make_unique<Item>();
        item->wantedAt = ++m_runs;
        update(name, *item);
    }
}

/// Lets go of what is not in the project any more, and of what nobody looked at for the longest time.
void VariationMedia::Item::forget(VariationMedia& media)
{
    std::vector<std::pair<int, QString>> unwanted;
    for (const auto& [name, item] : media.m_items) {
        const bool isThere = media.m_document.variation(name) != nullptr;
        const bool isKept = isThere && item->wantedAt >= 0;
        if (isThere && media.m_wanted.contains(name))
            continue;
        if (isKept && item->resultState.state == State::Learning)
            continue;
        unwanted.emplace_back(isKept ? item->wantedAt : -1, name);
        item->rest(media);
    }
    std::ranges::sort(unwanted, std::greater());
    const auto isGone = [](const auto& each) { return each.first < 0; };
    const auto firstGone = std::ranges::find_if(unwanted, isGone);
    const auto kept = std::min(mostKept, firstGone - unwanted.begin());
    for (const auto& [rank, name] : std::span(unwanted).subspan(static_cast<std::size_t>(kept))) {
        media.end(*media.m_items.at(name));
        media.m_items.erase(name);
        emit media.changed(name);
    }
}

/// Takes are aligned and variations drawn for those who look; what is begun is given up and begun anew when
/// somebody does.
void VariationMedia::Item::rest(VariationMedia& media)
{
    if (!resultState.job || resultState.job->isOver())
        return;
    media.end(*this);
    if (resultState.state == State::Opening)
        basis.reset();
    drawing.reset();
    resultState.state = opened == nullptr    ? State::Idle
                        : learned == nullptr ? State::NotLearned
                                             : State::Ready;
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

void VariationMedia::readStopped()
{
    for (const auto& [name, item] : m_items) {
        const VariationEntry* entry = m_document.variation(name);
        if (!item->resultState.isStopped || entry == nullptr ||
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
