// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/media/filehashes.h"
#include "model/project/media/sourcecache.h"
#include "model/project/store/resultmemory.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <typeindex>
#include <utility>

namespace quadrille {

/// What those share who work with a project, one value of it after the other: open sources, hashes of files,
/// results, and what is made of results and wanted by many (graphs, aligned takes). All of it is found by
/// content: an edit loses what depends on it and nothing else. Safe from any thread.
class ResultSession
{
public:
    const std::shared_ptr<SourceCache>& sources() const { return m_sources; }
    const std::shared_ptr<ResultMemory>& results() const { return m_results; }
    /// Hashes of files, with the memo of a folder of results.
    FileHashes& hashes(const std::filesystem::path& results);

    /// Something that is made of results: that which is there already as long as somebody holds it, and the
    /// last one of each type a while longer. Of several who ask for the same one makes it and the others
    /// wait. \param name  all that it depends on.
    template <typename Value, typename Make>
    std::shared_ptr<Value> shared(const std::string& name, const Make& make)
    {
        return std::static_pointer_cast<Value>(sharedAs(typeid(Value), name, [&]() -> std::shared_ptr<void> {
            return std::const_pointer_cast<std::remove_const_t<Value>>(make());
        }));
    }

    /// Such a thing where somebody made it and it is still there; null otherwise.
    template <typename Value>
    std::shared_ptr<Value> existing(const std::string& name) const
    {
        return std::static_pointer_cast<Value>(existingAs(typeid(Value), name));
    }

    /// Lets go of such things that nobody else holds.
    void forgetUnused();

    /// Notes that a step was computed.
    void countComputed(const std::string& step);
    /// How often steps were computed, by name.
    std::map<std::string, int> computed() const;

private:
    struct Slot
    {
        std::mutex making;
        std::weak_ptr<void> value; ///< guarded by m_mutex
    };
    using Name = std::pair<std::type_index, std::string>;
    using Maker = std::function<std::shared_ptr<void>()>;

    std::shared_ptr<void> sharedAs(std::type_index type, const std::string& name, const Maker& make);
    std::shared_ptr<void> existingAs(std::type_index type, const std::string& name) const;

    const std::shared_ptr<SourceCache> m_sources = std::make_shared<SourceCache>();
    const std::shared_ptr<ResultMemory> m_results = std::make_shared<ResultMemory>();
    mutable std::mutex m_mutex;
    std::map<std::filesystem::path, FileHashes> m_hashes;
    std::map<Name, std::shared_ptr<Slot>> m_shared;
    std::map<std::type_index, std::shared_ptr<void>> m_last;
    std::map<std::string, int> m_computed;
};

} // namespace quadrille
