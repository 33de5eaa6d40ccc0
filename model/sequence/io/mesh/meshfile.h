// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"
#include "model/sequence/framesource.h"
#include "model/sequence/io/files/format.h"
#include "model/sequence/topology.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// A mesh file, read whole. Vertices are those of the file, in its order.
struct MeshFile
{
    std::vector<Vec3f> positions;
    TopologyData topology;
    std::vector<Issue> issues;
    /// Files with the materials (OBJ), as the mesh names them.
    std::vector<std::string> materialLibraries;
    /// Textures as the mesh names them (PLY): one, or one per material of the topology.
    std::vector<std::string> textures;
};

/// Reads the positions of further files of a series that are laid out like its first file.
class PositionReader
{
public:
    virtual ~PositionReader() = default;
    PositionReader(const PositionReader&) = delete;
    PositionReader& operator=(const PositionReader&) = delete;

    /// \param content of a whole file. \param out positions of all vertices; left undefined on false.
    /// \return false where the file is not surely of the same topology and vertex count: then it must be read
    /// whole and compared.
    virtual bool read(std::string_view content, MutablePositions out) const = 0;

protected:
    PositionReader() = default;
};

/// A format with one mesh per file.
struct MeshFormat
{
    FormatInfo info;
    bool (*recognises)(std::string_view head) = nullptr;
    /// \throws Error syntax, counts, indices; with line or byte.
    MeshFile (*parse)(std::string_view content, const std::filesystem::path& file) = nullptr;
    /// The reader for files like this one; null when only whole reading will do.
    std::shared_ptr<const PositionReader> (*makePositionReader)(std::string_view content,
                                                                const MeshFile& mesh) = nullptr;
};

/// The importer of such a format, for single files and numbered series.
std::unique_ptr<Importer> makeMeshImporter(MeshFormat format);

/// Builds the topology that sequences share and reports what is odd about it.
/// \param positions of the first frame, to find triangles without area.
/// \throws Error NoVertices, NoFaces, IndexOutOfRange, PolygonSoup.
std::shared_ptr<const Topology> buildTopology(TopologyData data, Positions positions,
                                              const std::filesystem::path& file, std::vector<Issue>& issues);

/// Refuses a topology that is not that of the first frame, saying what differs first.
/// \throws Error VertexCountMismatch, TopologyMismatch.
void checkSameTopology(const TopologyData& first, const TopologyData& other,
                       const std::filesystem::path& file);

} // namespace quadrille
