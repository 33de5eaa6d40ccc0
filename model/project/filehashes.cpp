// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/filehashes.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"
#include "model/project/jsontext.h"

#include <chrono>
#include <optional>
#include <sys/stat.h>

namespace quadrille {

namespace {

struct FileStamp
{
    std::string text;
    std::int64_t changedNanoseconds = 0; ///< the later of content and status change
};

std::optional<FileStamp> stampOf(const std::filesystem::path& file)
{
    struct stat status = {};
    if (::stat(file.c_str(), &status) != 0)
        return std::nullopt;
    const auto nanoseconds = [](const timespec& time) {
        return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
    };
    const auto modified = nanoseconds(status.st_mtim);
    const auto changed = nanoseconds(status.st_ctim);
    std::string text = std::to_string(status.st_size);
    for (const std::int64_t part : {modified, changed, static_cast<std::int64_t>(status.st_ino)})
        text.append(" ").append(std::to_string(part));
    return FileStamp{std::move(text), std::max(modified, changed)};
}

/// A file that changed just now may change again without a visible difference in its times.
bool isSettled(const FileStamp& stamp)
{
    constexpr std::int64_t tick = 100'000'000;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count() - stamp.changedNanoseconds >
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
        if (known != m_known.end() && known->second.stamp == before->text)
            return known->second.hash;
    }
    const bool settled = before && isSettled(*before);
    std::string hash = hashFile(file, progress);
    const auto after = stampOf(file);
    if (settled && after && after->text == before->text) {
        const std::scoped_lock lock(m_mutex);
        m_known[name] = {before->text, hash};
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
