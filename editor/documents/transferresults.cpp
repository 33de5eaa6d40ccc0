// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/documents/transferresults.h"

#include "model/project/document/clipdependencies.h"
#include "model/project/document/findentry.h"

#include <algorithm>
#include <utility>

namespace quadrille {

namespace {

constexpr std::chrono::milliseconds transferDelay(30);

} // namespace

TransferResults::TransferResults(ProjectDocument& document, JobRunner& jobs, QObject* parent)
    : WantedResults(document, jobs, Section::Transfers, transferDelay, parent)
{
}

TransferResults::~TransferResults() = default;

void TransferResults::retry(const QString& name)
{
    Item* const item = find<Item>(name);
    if (item != nullptr && wanted().contains(name))
        compute(name, *item);
}

void TransferResults::refresh()
{
    for (const QString& name : wanted()) {
        if (Item* const item = find<Item>(name))
            item->made.reset();
    }
    updateSoon();
}

void TransferResults::follow(const ChangeEvent& event)
{
    if (event.kind == ChangeEvent::Kind::Reset) {
        forget([](const QString& /*name*/, const ResultState& /*state*/) { return true; });
    } else if (event.kind == ChangeEvent::Kind::Renamed && event.entry.section == Section::Transfers) {
        updateNow();
    } else {
        WantedResults::follow(event);
    }
}

/// A clip bears the name of its transfer: it is made again under the new one.
void TransferResults::renamed(const QString& /*before*/, const QString& name)
{
    Item* const item = find<Item>(name);
    if (item == nullptr)
        return;
    end(*item);
    item->made.reset();
}

void TransferResults::update()
{
    const Project& project = document().project();
    forget([&](const QString& name, const ResultState& /*state*/) {
        return !wanted().contains(name) || findTransfer(project, name.toStdString()) == nullptr;
    });
    for (const QString& name : wanted()) {
        if (findTransfer(project, name.toStdString()) == nullptr)
            continue;
        Item& item = make<Item>(name);
        Project basis = partsOfClip(project, "transfers/" + name.toStdString());
        if (item.made == basis)
            continue;
        item.made = std::move(basis);
        compute(name, item);
    }
}

void TransferResults::compute(const QString& name, Item& item)
{
    item.phase = ResultPhase::Computing;
    item.result.reset();
    emit changed(name);
    start(
        name, item, {.text = tr("Transfer “%1”").arg(name)},
        [working = document().working(), name = name.toStdString(),
         before = item.preview](const Progress& progress, const Post& post) {
            const ProjectResults results(working);
            const auto show = [&post](TransferPreviewPointer preview) {
                post([preview = std::move(preview)](const QString& /*name*/, ResultState& state) {
                    static_cast<Item&>(state).preview = preview;
                });
            };
            const TransferPreviewPointer preview =
                previewTransfer(results, name, before, progress.part(0, 0.3), show);
            show(preview);
            if (preview->failure)
                throw Error(*preview->failure);
            return openTransfer(results, name, progress.part(0.3, 1));
        },
        [this](const QString& current, TransferResultPointer result) {
            Item& done = *find<Item>(current);
            done.phase = ResultPhase::Ready;
            done.result = std::move(result);
            emit computed(current);
        });
}

} // namespace quadrille

#include "moc_transferresults.cpp"
