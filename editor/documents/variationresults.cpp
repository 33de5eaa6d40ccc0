// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/variationresults.h"

#include "editor/documents/variationitem.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds variationDelay(200);
/// Variations that nobody looks at now and that are kept all the same.
constexpr std::ptrdiff_t mostKept = 3;

} // namespace

VariationResults::VariationResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, Section::Variations, variationDelay, parent)
{
}

VariationResults::~VariationResults() = default;

const MeshSequence* VariationResults::clip(const QString& name, int number) const
{
    const State* found = resultState(name);
    if (found == nullptr || found->drawn == nullptr)
        return nullptr;
    for (const DrawnSet& set : *found->drawn) {
        const auto drawn = std::ranges::find(set.variations, number, &DrawnVariation::number);
        if (drawn != set.variations.end())
            return drawn->sequence.source == nullptr ? nullptr : &drawn->sequence;
    }
    return nullptr;
}

void VariationResults::renamed(const QString& /*before*/, const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    if (item->job) {
        // It answers for the old name.
        end(*item);
        item->basis.reset();
    }
    if (item->basis)
        item->basis->entry.name = name.toStdString();
}

void VariationResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        // What was kept is of another project.
        for (const auto& [name, state] : states())
            static_cast<Item&>(*state).wantedAt = -1;
        updateNow();
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Variations) {
        updateNow();
    } else {
        WantedResults::follow(event);
    }
}

void VariationResults::update()
{
    forgetUnwanted();
    for (const QString& name : wanted()) {
        if (document().variation(name) == nullptr)
            continue;
        Item& item = make<Item>(name);
        item.wantedAt = ++m_looks;
        update(name, item);
    }
}

/// Lets go of what is not in the project any more, and of what nobody looked at for the longest time.
void VariationResults::forgetUnwanted()
{
    std::vector<std::pair<int, QString>> unwanted;
    for (const auto& [name, state] : states()) {
        Item& item = static_cast<Item&>(*state);
        const bool isThere = document().variation(name) != nullptr;
        const bool isKept = isThere && item.wantedAt >= 0;
        if ((isThere && wanted().contains(name)) || (isKept && item.does(Work::Learning)))
            continue;
        unwanted.emplace_back(isKept ? item.wantedAt : -1, name);
        rest(item);
    }
    std::ranges::sort(unwanted, std::greater());
    const auto firstGone = std::ranges::find_if(unwanted, [](const auto& each) { return each.first < 0; });
    const auto kept = std::min(mostKept, firstGone - unwanted.begin());
    QStringList gone;
    for (const auto& [wantedAt, name] : std::span(unwanted).subspan(static_cast<std::size_t>(kept)))
        gone += name;
    forget([&](const QString& name, const ResultState& /*state*/) { return gone.contains(name); });
}

/// Takes are aligned and variations drawn for those who look; what is begun is given up and begun anew when
/// somebody does.
void VariationResults::rest(Item& item)
{
    if (!item.job || item.job->isOver())
        return;
    end(item);
    if (item.does(Work::Opening))
        item.basis.reset();
    item.drawing.reset();
    item.phase = item.restingPhase();
}

/// Does what is to be done next, one thing after the other.
void VariationResults::update(const QString& name, Item& item)
{
    const VariationEntry& entry = *document().variation(name);
    const VariationBasis basis = basisOf(document().project(), entry);
    if (entry.training.empty()) {
        end(item);
        Item empty;
        empty.wantedAt = item.wantedAt;
        empty.run = item.run;
        item = std::move(empty);
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

void VariationResults::readStopped()
{
    for (const auto& [name, state] : states()) {
        Item& item = static_cast<Item&>(*state);
        const VariationEntry* entry = document().variation(name);
        if (!item.isStopped || entry == nullptr || item.basis != basisOf(document().project(), *entry))
            continue;
        item.stopped = item.learned;
        retry(name);
    }
}

void VariationResults::retry(const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    item->basis.reset();
    update(name, *item);
}

void VariationResults::reopen()
{
    for (const auto& [name, state] : states()) {
        Item& item = static_cast<Item&>(*state);
        if (item.opened == nullptr || item.does(Work::Learning) || item.does(Work::Opening))
            continue;
        item.stopped = item.isStopped ? item.learned : nullptr;
        item.basis.reset();
    }
    updateSoon();
}

void VariationResults::stop(const QString& name)
{
    Item* const item = find<Item>(name);
    if (item != nullptr && item->job)
        item->job->cancel();
}

void VariationResults::stopped(const QString& name, ResultState& /*state*/)
{
    Item& item = *find<Item>(name);
    item.phase = item.restingPhase();
}

} // namespace quadrille

#include "moc_variationresults.cpp"
