// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/audio/soundtrack.h"
#include "model/core/error.h"
#include "model/core/progress.h"
#include "model/render/rendersettings.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

class WriteGuard;

/// What the registry and the dialogs need to know of a format.
struct FormatInfo
{
    std::string id;                      ///< "obj"
    std::string name;                    ///< "Wavefront OBJ", a proper name, not translated
    std::vector<std::string> extensions; ///< lower case with dot; the first is the usual one
    bool onePerFrame = false;            ///< a sequence is a numbered series of files
    bool needsMesh = false;              ///< holds positions only (PC2, MDD, npy)
    bool texturesBeside = false;         ///< pictures are written beside, see copyTextures
    bool frameTexturesBeside = false;    ///< the same, but only where each frame has its own
};

/// A file, or the files of a numbered series in natural order.
struct SourceFiles
{
    std::filesystem::path path;               ///< as the user named it: file, folder or pattern
    std::vector<std::filesystem::path> files; ///< one, or one per frame
    std::vector<std::int64_t> numbers;        ///< of the files of a series; empty for one file
    std::vector<std::int64_t> missing;        ///< numbers inside the range that have no file
    std::string stem;                         ///< name without number and extension

    bool isSeries() const { return !numbers.empty(); }
};

struct ImportOptions
{
    /// Mesh (OBJ, PLY, …) that gives faces and UVs to positions-only files.
    std::filesystem::path mesh;
    /// Rate of a source that names none; scenes whose keys are uneven are baked at it.
    double fps = 25.0;
    /// What the file's coordinates mean; where the format itself says (glTF), that wins.
    std::optional<CoordinateSystem> from;
    /// What the sequence shall be in.
    CoordinateSystem to;
    /// Only this clip of a scene file; all when empty.
    std::string clip;
    /// Texture, or folder or pattern with one texture per frame; looked for beside the source when empty.
    std::filesystem::path textures;
};

struct ImportResult
{
    /// One per animation clip; never empty.
    std::vector<MeshSequence> sequences;
    std::vector<Issue> issues;
    /// The source names its own rate.
    bool hasOwnFps = false;
    /// Its times are seconds: what names no rate is sampled at ImportOptions::fps, and lasts as long at any.
    bool isSampled = false;
    /// What the sequences' positions are in, where the format itself says (glTF, FBX, COLLADA); otherwise
    /// ImportOptions::from. The importer leaves the conversion to ImportOptions::to to `openSequences`.
    std::optional<CoordinateSystem> coordinates;
};

/// Reads one format. Stateless; one instance in the registry.
class Importer
{
public:
    virtual ~Importer() = default;
    virtual const FormatInfo& format() const = 0;
    /// True when a file that begins like this is surely of the format, whatever its name.
    /// \param head the first bytes of the file, at most 512.
    virtual bool recognises(std::string_view /*head*/) const { return false; }
    /// Opens without reading more frames than it must; frames are read when asked for. Positions are as the
    /// file has them: `openSequences` converts axes and unit, and reports an assumed rate and gaps.
    /// \throws Error file errors, syntax, topology, FormatNeedsMesh, Cancelled.
    virtual ImportResult open(const SourceFiles& source, const ImportOptions& options,
                              const Progress& progress) const = 0;
};

struct ExportOptions
{
    std::optional<FrameRange> range;
    /// Resamples; the sequence's own rate when empty.
    std::optional<double> fps;
    /// What the sequence is in, and what the file shall be in.
    CoordinateSystem from;
    CoordinateSystem to;
    bool textures = true;
    bool normals = true; ///< where the format holds them (glTF)
    /// Of pictures and videos; its axes follow `to`.
    RenderSettings render;
    std::optional<SoundTrack> sound; ///< of videos
    /// Decides what may be written over; null where nothing is asked.
    WriteGuard* guard = nullptr;
};

struct ExportResult
{
    std::vector<std::filesystem::path> files;
    std::vector<Issue> issues;
};

/// Writes one format. Stateless; one instance in the registry.
class Exporter
{
public:
    virtual ~Exporter() = default;
    virtual const FormatInfo& format() const = 0;
    /// Writes a sequence that is already cut, resampled and converted. Nothing half-written is left behind.
    /// \param out the file, or for one file per frame the name that gets numbers: DIR/NAME.ply →
    /// DIR/NAME_0000.ply, see numberedName. \throws Error WriteFailed, PermissionDenied, FormatCannotStore,
    /// BadArgument (what the guard refuses), Cancelled, and what reading frames throws.
    virtual ExportResult write(const MeshSequence& sequence, const std::filesystem::path& out,
                               const ExportOptions& options, const Progress& progress) const = 0;
};

} // namespace quadrille
