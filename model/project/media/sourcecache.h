// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/filestamp.h"
#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/sequence/texture.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

struct OpenedSequence;

/// Opens sources of sequences, each once for as long as somebody holds it: an edited project has the sources
/// of the one before, but for those that it names otherwise or whose files were written since. Safe from any
/// thread; of several that ask for the same source one opens it and the others wait.
class SourceCache
{
public:
    /// As openSource. Cost, where it is open: one system call for each file that the source is made of.
    /// \param character  null for none. \param folder  that relative paths are taken from.
    std::shared_ptr<const OpenedSequence> open(const SequenceEntry& entry, const CharacterEntry* character,
                                               const ProjectSettings& settings,
                                               const std::filesystem::path& folder, const Progress& progress);
    /// What makes textures by the model of an entry, as results have it: one for all who hold it, until one
    /// of these results is written anew. It reads the model when the first texture is asked for. \param
    /// folder  the project's.
    std::shared_ptr<const TextureBlender> blender(const AppearanceEntry& entry,
                                                  const std::filesystem::path& results,
                                                  const std::filesystem::path& folder);
    /// How many sources were opened so far.
    std::int64_t opened() const { return m_opened; }

private:
    /// All of a project that decides which frames and textures a source has; paths are absolute.
    struct Key
    {
        SequenceEntry entry;
        CharacterEntry character;
        ProjectSettings settings;
        bool operator==(const Key&) const = default;
    };
    struct Slot
    {
        std::mutex mutex;
        std::weak_ptr<const OpenedSequence> opened;
        std::vector<std::pair<std::filesystem::path, FileStamp>> files;
    };

    /// Models are told apart by what is read of them.
    struct BlenderKey
    {
        std::string name;
        VariedTextures varied = VariedTextures::Learned;
        std::vector<NamedFrame> completed; ///< that are to be
        std::filesystem::path results;
        std::filesystem::path folder;
        std::vector<std::optional<FileStamp>> files;
        bool operator==(const BlenderKey&) const = default;
    };

    static Key keyOf(const SequenceEntry& entry, const CharacterEntry* character,
                     const ProjectSettings& settings, const std::filesystem::path& folder);
    std::shared_ptr<Slot> slot(Key key);

    std::mutex m_mutex;
    std::vector<std::pair<Key, std::shared_ptr<Slot>>> m_slots;
    std::vector<std::pair<BlenderKey, std::weak_ptr<const TextureBlender>>> m_blenders;
    std::atomic<std::int64_t> m_opened{0};
};

} // namespace quadrille
