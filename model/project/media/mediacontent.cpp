// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/mediacontent.h"

#include "model/core/contenthash.h"
#include "model/core/file.h"
#include "model/project/json/jsontext.h"
#include "model/sequence/io/files/sourcefiles.h"

#include <algorithm>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

fs::path fileOfKnownMedia(const fs::path& cacheFolder)
{
    return cacheFolder / "media.json";
}

std::vector<fs::path> filesOfPattern(const fs::path& pattern)
{
    try {
        return findPattern(pattern).files;
    } catch (const Error&) {
        return {};
    }
}

} // namespace

bool mediumExists(const fs::path& medium)
{
    std::error_code error;
    return isPattern(medium) ? !filesOfPattern(medium).empty() : fs::exists(medium, error);
}

std::vector<fs::path> filesOfMedium(const fs::path& medium)
{
    if (isPattern(medium))
        return filesOfPattern(medium);
    std::error_code error;
    if (fs::is_regular_file(medium, error))
        return {medium};
    std::vector<fs::path> files;
    for (auto entry = fs::directory_iterator(medium, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code unreadable;
        if (entry->is_regular_file(unreadable))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    return files;
}

MediaContent contentOf(const std::vector<fs::path>& files, FileHashes& hashes, const Progress& progress)
{
    MediaContent content;
    ContentHasher all;
    for (const fs::path& file : files) {
        progress.report(0);
        content.hash = hashes.of(file, Progress(progress.token()));
        all.add(content.hash);
        std::error_code error;
        content.bytes += fs::file_size(file, error);
    }
    if (files.size() != 1)
        content.hash = all.hex();
    return content;
}

KnownMedia readKnownMedia(const fs::path& cacheFolder)
{
    const fs::path file = fileOfKnownMedia(cacheFolder);
    std::error_code error;
    if (!fs::exists(file, error))
        return {};
    try {
        KnownMedia known;
        const JsonText json = parseJson(readFile(file).text(), file);
        for (const auto& [path, content] : json.document.items())
            known[path] = {content.at("bytes").get<std::uint64_t>(), content.at("hash").get<std::string>()};
        return known;
    } catch (const Error&) {
        return {};
    } catch (const Json::exception&) {
        return {};
    }
}

void writeKnownMedia(const KnownMedia& known, const fs::path& cacheFolder)
{
    Json json = Json::object();
    for (const auto& [path, content] : known)
        json[path] = {{"bytes", content.bytes}, {"hash", content.hash}};
    writeAtomically(fileOfKnownMedia(cacheFolder), writeJson(json));
}

} // namespace quadrille
