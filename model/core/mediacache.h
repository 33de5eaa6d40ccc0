// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace quadrille {

/// Identifies one source of frames or textures for the life of the process.
class MediaId
{
public:
    MediaId() : m_value(next()) {}
    std::uint64_t value() const { return m_value; }

private:
    static std::uint64_t next()
    {
        static std::atomic<std::uint64_t> counter{0};
        return ++counter;
    }
    std::uint64_t m_value;
};

/// Keeps recently used frames and textures within a budget of bytes, least recently used dropped first. What
/// is still held elsewhere stays alive there. Safe from any thread; of several threads that miss the same
/// item one loads it and the others wait for it.
class MediaCache
{
public:
    struct Loaded
    {
        std::shared_ptr<const void> item;
        std::size_t bytes = 0;
    };
    struct Statistics
    {
        std::size_t bytes = 0;
        std::size_t budget = 0;
        std::size_t items = 0;
        std::uint64_t hits = 0;
        std::uint64_t misses = 0;
    };

    static constexpr std::size_t defaultBudget = std::size_t{512} << 20;

    /// 512 MB by default.
    explicit MediaCache(std::size_t budgetBytes = defaultBudget);

    /// The cache that everything uses unless told otherwise.
    static const std::shared_ptr<MediaCache>& shared();

    /// Item `index` of a source, from the cache or by `load`, which runs without a lock and may throw (what
    /// it throws reaches all who wait). `load` must not ask for the same item.
    std::shared_ptr<const void> get(MediaId id, std::int64_t index, const std::function<Loaded()>& load);
    /// Forgets all items of a source. One that is being loaded is kept when it comes all the same. Cost:
    /// linear in all items.
    void drop(MediaId id);
    /// Drops what is beyond it at once. An item larger than the budget is handed out, but not kept.
    void setBudget(std::size_t bytes);
    /// Hits and misses count from the beginning; waiting for a load of another thread is a hit.
    Statistics statistics() const;

private:
    struct Key
    {
        std::uint64_t id;
        std::int64_t index;
        bool operator==(const Key&) const = default;
    };
    struct KeyHash
    {
        std::size_t operator()(const Key& key) const noexcept;
    };
    struct Entry
    {
        Key key;
        Loaded loaded;
    };

    void keep(const Key& key, Loaded loaded);
    void shrink();

    mutable std::mutex m_mutex;
    std::list<Entry> m_entries; ///< most recently used first
    std::unordered_map<Key, std::list<Entry>::iterator, KeyHash> m_byKey;
    std::unordered_map<Key, std::shared_future<std::shared_ptr<const void>>, KeyHash> m_loading;
    Statistics m_statistics;
};

} // namespace quadrille
