// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/filestamp.h"
#include "model/project/store/result.h"

#include <filesystem>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace quadrille {

/// What a process knows of results, in front of the files that hold them: the results used last, within a
/// budget of bytes, and which files were read or written and found whole, so that they need not be read again
/// to know it. Safe from any thread.
class ResultMemory
{
public:
    static constexpr std::uint64_t defaultBudget = std::uint64_t{256} << 20;

    explicit ResultMemory(std::uint64_t budgetBytes = defaultBudget) : m_budget(budgetBytes) {}

    /// A result by what it makes and the hash of its inputs, see BuildStep; null where it is not kept.
    /// Cost: O(log results).
    ResultPointer find(const std::string& kind, const std::string& key);
    /// Keeps a result, unless it takes more than a quarter of the budget: large tables would put all others
    /// out.
    void keep(const std::string& kind, const std::string& key, ResultPointer result);

    /// A result file as it was found.
    struct Known
    {
        FileStamp stamp;
        std::string key;
        std::vector<WrittenFile> files; ///< that the result names
    };
    /// What is known of a file; nothing where it was never found whole, or was written since. Cost: one
    /// system call.
    std::optional<Known> known(const std::filesystem::path& file) const;
    /// A file holds this result now.
    void note(const std::filesystem::path& file, const std::string& key, const Result& result);

private:
    using Name = std::pair<std::string, std::string>; ///< kind, key
    struct Kept
    {
        Name name;
        ResultPointer result;
        std::uint64_t bytes = 0;
    };

    const std::uint64_t m_budget;
    mutable std::mutex m_mutex;
    std::uint64_t m_bytes = 0;
    std::list<Kept> m_kept; ///< used last first
    std::map<Name, std::list<Kept>::iterator> m_byName;
    std::map<std::filesystem::path, Known> m_known;
};

} // namespace quadrille
