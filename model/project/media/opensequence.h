// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/project/document/project.h"
#include "model/project/media/sourcecache.h"
#include "model/sequence/meshsequence.h"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace quadrille {

/// A sequence as the project has it: cut, at settings.fps, in settings.axes, with labels, contacts and
/// textures.
struct OpenedSequence
{
    MeshSequence sequence;
    std::vector<Issue> issues;
    /// The files that it is made of: source, mesh and textures.
    std::vector<std::filesystem::path> files;
};

/// Opens the sequences of a project, each once; those of one character share one topology. Safe from any
/// thread. Holds a copy of the project: a changed project wants a new opener, which shares the sources.
class SequenceOpener
{
public:
    /// \param results  the folder of the project's results, where clips are found that are computed; empty:
    /// sequences that show such clips cannot be opened. \param sources  that are open already; null: none.
    SequenceOpener(Project project, std::filesystem::path folder, std::filesystem::path results = {},
                   std::shared_ptr<SourceCache> sources = nullptr);

    const Project& project() const { return m_project; }
    const std::filesystem::path& folder() const { return m_folder; }

    /// \throws Error what opening its files throws; TopologyMismatch or VertexCountMismatch against the
    /// character's mesh, saying what differs; RangeOutside; ImageCountMismatch; ProjectInvalid where there is
    /// no such sequence or the source holds several clips and none is named.
    std::shared_ptr<const OpenedSequence> open(const std::string& name, const Progress& progress = {});
    /// A clip by its section and name: "sequences/NAME" or "animations/NAME". The clip of an animation is
    /// read from the results, as it is there. \throws Error as open; ProjectInvalid where it is not computed.
    std::shared_ptr<const OpenedSequence> openClip(const std::string& clip, const Progress& progress = {});
    /// The files that a sequence is made of. Those of a computed clip are its result's own inputs: none.
    /// \throws Error as open.
    std::vector<std::filesystem::path> filesOf(const std::string& name, const Progress& progress = {});

private:
    struct Slot
    {
        std::mutex mutex;
        std::shared_ptr<const OpenedSequence> opened;
    };
    struct Mesh
    {
        std::mutex mutex;
        std::shared_ptr<const Topology> topology;
    };

    OpenedSequence openEntry(const SequenceEntry& entry, const Progress& progress);
    OpenedSequence openMadeClip(const std::string& clip, const Progress& progress);
    OpenedSequence openProjection(const ProjectionEntry& entry, const Progress& progress);
    OpenedSequence openFile(const SequenceEntry& entry, const CharacterEntry* character,
                            const Progress& progress);
    void shareTopology(OpenedSequence& opened, const CharacterEntry& character);
    /// What makes the textures between those of a character; null where it has no model of appearance.
    std::shared_ptr<const TextureBlender> blenderOf(const std::string& character);
    Slot& slot(const std::string& clip);

    Project m_project;
    std::filesystem::path m_folder;
    std::filesystem::path m_results;
    std::shared_ptr<SourceCache> m_sources;
    /// Held for as long as the opener lives.
    std::vector<std::shared_ptr<const OpenedSequence>> m_held;
    std::mutex m_mutex;
    std::map<std::string, Slot> m_slots;                                     ///< by clip
    std::map<std::string, Mesh> m_meshes;                                    ///< by character
    std::map<std::string, std::shared_ptr<const TextureBlender>> m_blenders; ///< by model of appearance
};

/// One sequence by itself; see SequenceOpener::open.
/// \param folder the project file's.
OpenedSequence openSequence(const Project& project, const std::filesystem::path& folder,
                            const SequenceEntry& entry, const Progress& progress = {});

/// The source of a sequence that is a file or series: all its frames at their own rate, in settings.axes,
/// with the textures that entry or character name; nothing is cut, marked or named. \param character may be
/// null. \throws Error what opening its files throws; ImageCountMismatch; ProjectInvalid where the source
/// holds several clips and none is named.
OpenedSequence openSource(const SequenceEntry& entry, const CharacterEntry* character,
                          const ProjectSettings& settings, const std::filesystem::path& folder,
                          const Progress& progress = {});

} // namespace quadrille
