// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// What is under way for variations: their takes are aligned, their models learned, they are drawn.
#include "editor/documents/drawnresults.h"
#include "editor/documents/variationitem.h"

#include <QElapsedTimer>
#include <utility>

namespace quadrille {

namespace {

/// Between the states of learning that are shown.
constexpr int variationShowing = 150; // milliseconds

} // namespace

VariationJob VariationResults::jobOf(const QString& name) const
{
    return {document().working(), name.toStdString()};
}

void VariationResults::open(const QString& name, Item& item, const VariationBasis& basis)
{
    item.basis = basis;
    item.phase = ResultPhase::Computing;
    item.work = Work::Opening;
    start(
        name, item, {.text = tr("Aligning “%1”").arg(name)},
        [job = jobOf(name)](const Progress& progress, const Post& /*post*/) {
            return std::make_shared<const OpenedVariation>(openVariation(job, progress));
        },
        [this](const QString& current, std::shared_ptr<const OpenedVariation> opened) {
            Item& done = *find<Item>(current);
            done.opened = std::move(opened);
            done.movement = done.opened->movement;
            done.phase = ResultPhase::Idle;
            done.drawing.reset();
            done.drawn.reset();
            done.parts.clear();
            done.isStopped = false;
            done.learned.reset();
            const auto stopped = std::exchange(done.stopped, nullptr);
            if (const auto learned = done.opened->learned != nullptr ? done.opened->learned : stopped)
                takeLearned(current, done, learned);
        });
}

void VariationResults::learn(const QString& name)
{
    if (isUpdateDue())
        updateNow();
    Item* const item = find<Item>(name);
    if (item == nullptr || item->does(Work::Opening))
        return;
    if (item->opened == nullptr) {
        retry(name);
        return;
    }
    item->phase = ResultPhase::Computing;
    item->work = Work::Learning;
    item->isStopped = false;
    item->parts.clear();
    item->learned.reset();
    for (const BodyPart& part : item->movement->parts.parts)
        item->parts.push_back({.part = part.name});
    start(
        name, *item, {.text = tr("Learning “%1”").arg(name)},
        [this, job = jobOf(name), opened = item->opened](const Progress& progress, const Post& post) {
            QElapsedTimer sinceShown;
            const auto show = [&](const std::vector<PartProgress>& parts) {
                if (sinceShown.isValid() && sinceShown.elapsed() < variationShowing)
                    return;
                post([parts](const QString& /*name*/, ResultState& state) {
                    if (auto& shown = static_cast<Item&>(state); shown.does(Work::Learning))
                        shown.parts = parts;
                });
                sinceShown.start();
            };
            // The best before learning was stopped counts too.
            const auto learned = learnVariation(job, *opened, progress, show);
            post([this, learned](const QString& current, ResultState& state) {
                takeLearned(current, static_cast<Item&>(state), learned);
            });
        },
        [](const QString& /*name*/) {});
}

void VariationResults::takeLearned(const QString& name, Item& item,
                                   std::shared_ptr<const LearnedVariation> learned)
{
    item.learned = std::move(learned);
    item.parts = item.learned->parts;
    item.isStopped = item.learned->isStopped();
    item.phase = ResultPhase::Idle;
    item.drawing.reset();
    if (item.learned == item.opened->learned && item.opened->drawn != nullptr) {
        item.drawn = item.opened->drawn;
        item.drawing = item.opened->drawing;
        item.phase = ResultPhase::Ready;
    }
    if (wanted().contains(name))
        update(name, item);
}

void VariationResults::draw(const QString& name, Item& item)
{
    item.drawing = drawingOf(*document().variation(name));
    item.phase = ResultPhase::Computing;
    item.work = Work::Drawing;
    start(
        name, item, {.text = tr("Drawing “%1”").arg(name)},
        [job = jobOf(name), opened = item.opened, learned = item.learned](const Progress& progress,
                                                                          const Post& /*post*/) {
            return drawVariations(job, *opened, *learned, progress);
        },
        [this](const QString& current, std::shared_ptr<const std::vector<DrawnSet>> drawn) {
            Item& done = *find<Item>(current);
            done.drawn = std::move(drawn);
            done.phase = ResultPhase::Ready;
        });
}

} // namespace quadrille
