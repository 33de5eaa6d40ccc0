// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/basemesh.h"

#include "model/core/error.h"
#include "model/sequence/io/files/sourcefiles.h"
#include "model/sequence/io/registry.h"

#include <map>
#include <mutex>
#include <system_error>
#include <tuple>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// A file as it was read.
struct MeshStamp
{
    std::uintmax_t bytes = 0;
    fs::file_time_type changed;

    bool operator==(const MeshStamp&) const = default;
};

struct KeptMesh
{
    std::mutex mutex;
    MeshStamp stamp;
    std::weak_ptr<const Topology> topology;
    TextureSet textures;
    std::vector<Issue> issues;
};

std::shared_ptr<KeptMesh> keptMesh(const fs::path& file)
{
    static std::mutex mutex;
    static std::map<fs::path, std::shared_ptr<KeptMesh>> meshes;
    const std::scoped_lock lock(mutex);
    std::erase_if(meshes, [](const auto& mesh) {
        return mesh.second.use_count() == 1 && mesh.second->topology.expired();
    });
    auto& mesh = meshes[file];
    if (mesh == nullptr)
        mesh = std::make_shared<KeptMesh>();
    return mesh;
}

BaseMesh parse(const SourceFiles& source, const Progress& progress)
{
    const Importer& importer = importerFor(source);
    if (importer.format().needsMesh)
        throw Error(ErrorCode::NoFaces, {source.path, {}, {}});
    ImportResult result = importer.open(source, {}, progress);
    const MeshSequence& mesh = result.sequences.front();
    return {mesh.topology, mesh.textures, std::move(result.issues)};
}

} // namespace

BaseMesh readBaseMesh(const fs::path& file, const Progress& progress)
{
    const SourceFiles source = findSource(file);
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(source.files.front(), error);
    const MeshStamp stamp{fs::file_size(source.files.front(), error),
                          fs::last_write_time(source.files.front(), error)};
    if (error || source.files.size() > 1)
        return parse(source, progress);
    const std::shared_ptr<KeptMesh> kept = keptMesh(whole);
    const std::scoped_lock lock(kept->mutex);
    if (auto topology = kept->topology.lock(); topology != nullptr && kept->stamp == stamp)
        return {std::move(topology), kept->textures, kept->issues};
    BaseMesh mesh = parse(source, progress);
    kept->stamp = stamp;
    kept->topology = mesh.topology;
    kept->textures = mesh.textures;
    kept->issues = mesh.issues;
    return mesh;
}

} // namespace quadrille
