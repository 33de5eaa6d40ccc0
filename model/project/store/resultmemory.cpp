// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/resultmemory.h"

namespace quadrille {

ResultPointer ResultMemory::find(const std::string& kind, const std::string& key)
{
    const std::scoped_lock lock(m_mutex);
    const auto found = m_byName.find({kind, key});
    if (found == m_byName.end())
        return nullptr;
    m_kept.splice(m_kept.begin(), m_kept, found->second);
    return found->second->result;
}

void ResultMemory::keep(const std::string& kind, const std::string& key, ResultPointer result)
{
    const std::uint64_t bytes = bytesOf(*result);
    constexpr std::uint64_t largestShare = 4;
    if (bytes > m_budget / largestShare)
        return;
    const std::scoped_lock lock(m_mutex);
    Name name{kind, key};
    if (const auto known = m_byName.find(name); known != m_byName.end()) {
        m_bytes -= known->second->bytes;
        m_kept.erase(known->second);
    }
    m_kept.push_front({name, std::move(result), bytes});
    m_byName.insert_or_assign(std::move(name), m_kept.begin());
    m_bytes += bytes;
    while (m_bytes > m_budget) {
        m_bytes -= m_kept.back().bytes;
        m_byName.erase(m_kept.back().name);
        m_kept.pop_back();
    }
}

std::optional<ResultMemory::Known> ResultMemory::known(const std::filesystem::path& file) const
{
    const std::scoped_lock lock(m_mutex);
    const auto found = m_known.find(file);
    if (found == m_known.end() || stampOf(file) != found->second.stamp)
        return std::nullopt;
    return found->second;
}

void ResultMemory::note(const std::filesystem::path& file, const std::string& key, const Result& result)
{
    const auto stamp = stampOf(file);
    const std::scoped_lock lock(m_mutex);
    if (stamp)
        m_known.insert_or_assign(file, Known{*stamp, key, result.files});
    else
        m_known.erase(file);
}

} // namespace quadrille
