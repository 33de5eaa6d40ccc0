// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/resultsession.h"

#include <tbb/task_arena.h>

namespace quadrille {

FileHashes& ResultSession::hashes(const std::filesystem::path& results)
{
    const std::scoped_lock lock(m_mutex);
    return m_hashes.try_emplace(results, results / "hashes.json").first->second;
}

std::shared_ptr<void> ResultSession::sharedAs(std::type_index type, const std::string& name,
                                              const Maker& make)
{
    std::shared_ptr<Slot> slot;
    {
        const std::scoped_lock lock(m_mutex);
        std::erase_if(m_shared, [](const auto& each) {
            return each.second.use_count() == 1 && each.second->value.expired();
        });
        std::shared_ptr<Slot>& own = m_shared[{type, name}];
        if (!own)
            own = std::make_shared<Slot>();
        slot = own;
    }
    const std::scoped_lock making(slot->making);
    std::shared_ptr<void> value = existingAs(type, name);
    if (!value)
        // A thread that waits inside must not begin with something else that waits for this value.
        value = tbb::this_task_arena::isolate(make);
    std::shared_ptr<void> before; // destroyed without the lock
    const std::scoped_lock lock(m_mutex);
    slot->value = value;
    before = std::exchange(m_last[type], value);
    return value;
}

std::shared_ptr<void> ResultSession::existingAs(std::type_index type, const std::string& name) const
{
    const std::scoped_lock lock(m_mutex);
    const auto found = m_shared.find({type, name});
    return found == m_shared.end() ? nullptr : found->second->value.lock();
}

void ResultSession::forgetUnused()
{
    std::map<std::type_index, std::shared_ptr<void>> last; // destroyed without the lock
    const std::scoped_lock lock(m_mutex);
    last.swap(m_last);
}

void ResultSession::countComputed(const std::string& step)
{
    const std::scoped_lock lock(m_mutex);
    ++m_computed[step];
}

std::map<std::string, int> ResultSession::computed() const
{
    const std::scoped_lock lock(m_mutex);
    return m_computed;
}

} // namespace quadrille
