// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/steps/flowfiles.h"

#include "model/core/contenthash.h"
#include "model/core/error.h"
#include "model/core/file.h"

#include <cstring>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t digits = 32; ///< of a hash

std::string hashOf(std::span<const float> warp)
{
    ContentHasher hasher;
    hasher.addBytes(std::as_bytes(warp));
    return hasher.hex();
}

} // namespace

FlowFiles::FlowFiles(fs::path folder, std::vector<std::string> hashes, std::string settings,
                     std::vector<fs::path> others)
    : m_folder(std::move(folder))
    , m_hashes(std::move(hashes))
    , m_settings(std::move(settings))
    , m_others(std::move(others))
{
}

fs::path FlowFiles::fileOf(const Key& key) const
{
    ContentHasher hasher;
    hasher.add(m_hashes[static_cast<std::size_t>(key.texture)]);
    hasher.add(m_hashes[static_cast<std::size_t>(key.reference)]);
    hasher.add(static_cast<std::int64_t>(key.method));
    hasher.add(m_settings);
    fs::path file = m_folder / (hasher.hex() + ".warp");
    const std::scoped_lock lock(m_mutex);
    m_used.insert(file);
    return file;
}

std::optional<std::vector<float>> FlowFiles::get(const Key& key) const
{
    const fs::path file = fileOf(key);
    std::error_code error;
    for (auto other = m_others.begin(); other != m_others.end() && !fs::exists(file, error); ++other) {
        fs::create_directories(m_folder, error);
        fs::copy_file(*other / file.filename(), file, error);
    }
    try {
        const FileContent content = readFile(file);
        if (content.size < digits || (content.size - digits) % sizeof(float) != 0)
            return std::nullopt;
        std::vector<float> warp((content.size - digits) / sizeof(float));
        std::memcpy(warp.data(), content.bytes().subspan(digits).data(), content.size - digits);
        return content.text().starts_with(hashOf(warp)) ? std::optional(std::move(warp)) : std::nullopt;
    } catch (const Error&) {
        return std::nullopt; // not there, or not to be read
    }
}

void FlowFiles::put(const Key& key, std::span<const float> warp)
{
    const std::span<const std::byte> bytes = std::as_bytes(warp);
    std::string content = hashOf(warp);
    content.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
        writeAtomically(fileOf(key), content);
    } catch (const Error&) {
        return; // it is computed again when it is wanted again
    }
}

void FlowFiles::removeOthers() const
{
    const std::scoped_lock lock(m_mutex);
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(m_folder, error)) {
        if (entry.path().extension() == ".warp" && !m_used.contains(entry.path()))
            fs::remove(entry.path(), error);
    }
}

} // namespace quadrille
