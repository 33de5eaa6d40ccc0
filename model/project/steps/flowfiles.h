// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/appearance/alignment.h"

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace quadrille {

/// Forward warps in files of a folder, by the content of the textures that they align: what was computed
/// before it was cancelled, or for another number of components, is not computed again. A file that is
/// damaged counts as missing. Safe from any thread.
class FlowFiles : public FlowCache
{
public:
    /// \param hashes  of each texture's content. \param settings  all else that warps depend on.
    /// \param others  folders of the same kind: what lies there and not in the first is copied when it is
    /// read.
    FlowFiles(std::filesystem::path folder, std::vector<std::string> hashes, std::string settings,
              std::vector<std::filesystem::path> others = {});

    std::optional<std::vector<float>> get(const Key& key) const override;
    /// What cannot be written is not kept.
    void put(const Key& key, std::span<const float> warp) override;
    /// Removes the files of the folder that were neither read nor written.
    void removeOthers() const;

private:
    std::filesystem::path fileOf(const Key& key) const;

    std::filesystem::path m_folder;
    std::vector<std::string> m_hashes;
    std::string m_settings;
    std::vector<std::filesystem::path> m_others;
    mutable std::mutex m_mutex;
    mutable std::set<std::filesystem::path> m_used;
};

} // namespace quadrille
