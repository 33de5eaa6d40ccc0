// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/documents/variationbasis.h"
#include "editor/documents/variationmedia.h"
#include "editor/documents/variationwork.h"

#include <mutex>
#include <utility>

namespace quadrille {

/// A variation with the work on it.
struct VariationMedia::Item
{
    ResultState resultState;
    std::optional<VariationBasis> basis; ///< of `opened` and `learned`
    std::shared_ptr<const OpenedVariation> opened;
    std::shared_ptr<const LearnedVariation> learned; ///< null before learning
    std::shared_ptr<const LearnedVariation> stopped; ///< to go on with where there is nothing better
    std::optional<VariationDrawing> drawing;         ///< of `drawn`
    int run = 0;                                     ///< counts work, so that late results are known
    int wantedAt = 0;                                ///< counts, too: the greater the later

    static void forget(VariationMedia& media);
    void rest(VariationMedia& media);
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
            if (item == nullptr || item->resultState.state != State::Learning)
                return;
            item->resultState.parts = std::move(parts);
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

} // namespace quadrille
