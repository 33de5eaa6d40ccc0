// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/mediacache.h"

namespace quadrille {

std::size_t MediaCache::KeyHash::operator()(const Key& key) const noexcept
{
    return std::hash<std::uint64_t>{}(key.id * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(key.index));
}

MediaCache::MediaCache(std::size_t budgetBytes)
{
    m_statistics.budget = budgetBytes;
}

const std::shared_ptr<MediaCache>& MediaCache::shared()
{
    static const auto cache = std::make_shared<MediaCache>();
    return cache;
}

std::shared_ptr<const void> MediaCache::get(MediaId id, std::int64_t index,
                                            const std::function<Loaded()>& load)
{
    const Key key{id.value(), index};
    std::promise<std::shared_ptr<const void>> promise;
    {
        std::unique_lock lock(m_mutex);
        if (const auto found = m_byKey.find(key); found != m_byKey.end()) {
            ++m_statistics.hits;
            m_entries.splice(m_entries.begin(), m_entries, found->second);
            return found->second->loaded.item;
        }
        if (const auto found = m_loading.find(key); found != m_loading.end()) {
            ++m_statistics.hits;
            const auto awaited = found->second;
            lock.unlock();
            return awaited.get();
        }
        ++m_statistics.misses;
        m_loading.emplace(key, promise.get_future().share());
    }
    try {
        Loaded loaded = load();
        auto item = loaded.item;
        keep(key, std::move(loaded));
        promise.set_value(item);
        return item;
    } catch (...) {
        const std::scoped_lock lock(m_mutex);
        m_loading.erase(key);
        promise.set_exception(std::current_exception());
        throw;
    }
}

void MediaCache::keep(const Key& key, Loaded loaded)
{
    const std::scoped_lock lock(m_mutex);
    m_loading.erase(key);
    m_statistics.bytes += loaded.bytes;
    m_entries.push_front({key, std::move(loaded)});
    m_byKey.emplace(key, m_entries.begin());
    shrink();
}

void MediaCache::drop(MediaId id)
{
    const std::scoped_lock lock(m_mutex);
    for (auto entry = m_entries.begin(); entry != m_entries.end();) {
        if (entry->key.id == id.value()) {
            m_statistics.bytes -= entry->loaded.bytes;
            m_byKey.erase(entry->key);
            entry = m_entries.erase(entry);
        } else {
            ++entry;
        }
    }
}

void MediaCache::setBudget(std::size_t bytes)
{
    const std::scoped_lock lock(m_mutex);
    m_statistics.budget = bytes;
    shrink();
}

MediaCache::Statistics MediaCache::statistics() const
{
    const std::scoped_lock lock(m_mutex);
    auto statistics = m_statistics;
    statistics.items = m_entries.size();
    return statistics;
}

void MediaCache::shrink()
{
    while (m_statistics.bytes > m_statistics.budget && !m_entries.empty()) {
        m_statistics.bytes -= m_entries.back().loaded.bytes;
        m_byKey.erase(m_entries.back().key);
        m_entries.pop_back();
    }
}

} // namespace quadrille
