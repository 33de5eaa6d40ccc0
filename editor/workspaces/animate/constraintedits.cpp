// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "editor/workspaces/animate/constraintedits.h"

#include "model/project/results/openanimation.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

template <typename Entry>
std::vector<Entry> entriesOf(const AnimationEntry& animation)
{
    std::vector<Entry> entries;
    for (const ConstraintEntry& constraint : animation.constraints)
        if (const Entry* entry = std::get_if<Entry>(&constraint))
            entries.push_back(*entry);
    return entries;
}

template <typename Entry>
void setEntries(AnimationEntry& animation, std::vector<Entry> entries)
{
    std::vector<ConstraintEntry> after;
    auto next = entries.begin();
    for (ConstraintEntry& constraint : animation.constraints) {
        if (!std::holds_alternative<Entry>(constraint))
            after.push_back(std::move(constraint));
        else if (next != entries.end())
            after.emplace_back(std::move(*next++));
    }
    for (; next != entries.end(); ++next)
        after.emplace_back(std::move(*next));
    animation.constraints = std::move(after);
}

/// What was found for the n-th of those that are alike is for the n-th of them now.
template <typename Entry, typename Outcome, typename AreAlike>
std::vector<std::optional<Outcome>> outcomes(const std::vector<Entry>& entries,
                                             const std::vector<Entry>& solved,
                                             const std::vector<Outcome>& found, const AreAlike& areAlike)
{
    std::vector<std::optional<Outcome>> result(entries.size());
    std::vector<bool> isTaken(solved.size(), false);
    for (std::size_t i = 0; i < entries.size(); ++i)
        for (std::size_t k = 0; k < std::min(solved.size(), found.size()); ++k)
            if (!isTaken[k] && areAlike(entries[i], solved[k])) {
                isTaken[k] = true;
                result[i] = found[k];
                break;
            }
    return result;
}

} // namespace

std::vector<KeyEntry> keysOf(const AnimationEntry& animation)
{
    return entriesOf<KeyEntry>(animation);
}

void setKeys(AnimationEntry& animation, std::vector<KeyEntry> keys)
{
    std::ranges::stable_sort(keys, {}, &KeyEntry::time);
    setEntries(animation, std::move(keys));
}

std::vector<ActionEntry> actionsOf(const AnimationEntry& animation)
{
    return entriesOf<ActionEntry>(animation);
}

void setActions(AnimationEntry& animation, std::vector<ActionEntry> actions)
{
    setEntries(animation, std::move(actions));
}

double freeKeyTime(const std::vector<KeyEntry>& keys, double time, double fps)
{
    const auto isTaken = [&](double wanted) {
        return std::ranges::any_of(
            keys, [&](const KeyEntry& key) { return std::abs(key.time - wanted) * fps < 0.5; });
    };
    double free = std::max(0.0, time);
    while (isTaken(free))
        free += 1.0 / fps;
    return free;
}

std::vector<std::optional<std::int64_t>> obtainedFrames(const std::vector<KeyEntry>& keys,
                                                        const AnimationResult* result)
{
    if (result == nullptr)
        return std::vector<std::optional<std::int64_t>>(keys.size());
    std::vector<std::int64_t> found;
    for (const KeyTime& key : result->walk.solution.keys)
        found.push_back(key.obtained);
    return outcomes(keys, keysOf(result->entry), found, [](const KeyEntry& a, const KeyEntry& b) {
        return a.sequence == b.sequence && a.frame == b.frame;
    });
}

std::vector<std::optional<FrameRange>> obtainedRanges(const std::vector<ActionEntry>& actions,
                                                      const AnimationResult* result)
{
    if (result == nullptr)
        return std::vector<std::optional<FrameRange>>(actions.size());
    return outcomes(actions, actionsOf(result->entry), result->walk.solution.actions, std::equal_to<>());
}

} // namespace quadrille
