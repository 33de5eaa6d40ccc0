// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/filehashes.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/filestamp.h"
#include "model/project/json/jsontext.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace quadrille {

namespace {

/// As the memo keeps it.
std::string textOf(const FileStamp& stamp)
{
    std::string text = std::to_string(stamp.size);
    for (const std::int64_t part : {stamp.modified, stamp.changed, static_cast<std::int64_t>(stamp.number)})
        text.append(" ").append(std::to_string(part));
    return text;
}

/// A file that changed just now may change again without a visible difference in its times.
bool isSettled(const FileStamp& stamp)
{
    constexpr std::int64_t tick = 100'000'000;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() -
               std::max(stamp.modified, stamp.changed) >
           tick;
}

} // namespace

FileHashes::FileHashes(std::filesystem::path memo) : m_memo(std::move(memo))
{
    std::error_code error;
    if (m_memo.empty() || !std::filesystem::exists(m_memo, error))
        return;
    try {
        const JsonText json = parseJson(readFile(m_memo).text(), m_memo);
        for (const auto& [file, known] : json.document.items())
            m_known[file] = {known.at(0).get<std::string>(), known.at(1).get<std::string>()};
    } catch (const Error&) {
        m_known.clear();
    } catch (const Json::exception&) {
        m_known.clear();
    }
}

std::string FileHashes::of(const std::filesystem::path& file, const Progress& progress)
{
    const std::string name = std::filesystem::absolute(file).lexically_normal().string();
    const auto before = stampOf(file);
    if (before) {
        const std::scoped_lock lock(m_mutex);
        const auto known = m_known.find(name);
        if (known != m_known.end() && known->second.stamp == textOf(*before))
            return known->second.hash;
    }
    const bool settled = before && isSettled(*before);
    std::string hash = hashFile(file, progress);
    const auto after = stampOf(file);
    if (settled && after && *after == *before) {
        const std::scoped_lock lock(m_mutex);
        m_known[name] = {textOf(*before), hash};
        m_changed = true;
    }
    return hash;
}

void FileHashes::save()
{
    const std::scoped_lock lock(m_mutex);
    if (m_memo.empty() || !m_changed)
        return;
    Json json = Json::object();
    for (const auto& [file, known] : m_known)
        json[file] = Json::array({known.stamp, known.hash});
    try {
        writeAtomically(m_memo, json.dump(0, ' ', false, Json::error_handler_t::replace));
        m_changed = false;
    } catch (const Error&) {
        // Hashing again next time is all that is lost.
        m_changed = true;
    }
}

} // namespace quadrille
