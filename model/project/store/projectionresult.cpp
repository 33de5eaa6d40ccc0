// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/projectionresult.h"

#include "model/project/document/madeclips.h"
#include "model/project/document/paths.h"
#include "model/project/store/resultstore.h"

namespace quadrille {

std::filesystem::path projectionFolder(const std::filesystem::path& results, const std::string& name)
{
    return results / "projections" / name / "files";
}

std::optional<TextureSet> projectedTextures(const std::filesystem::path& results,
                                            const std::filesystem::path& folder, const std::string& name,
                                            const MeshSequence& clip)
{
    if (results.empty())
        return std::nullopt;
    const ResultPointer stored = ResultStore(results).load(clipStepOf("projections/" + name), {}).result;
    if (std::ssize(stored->files) != clip.frameCount())
        return std::nullopt;
    std::vector<Texture> textures(static_cast<std::size_t>(clip.source->frameCount()));
    for (FrameIndex f(0); f.value < clip.frameCount(); ++f) {
        const std::string& path = stored->files[static_cast<std::size_t>(f.value)].path;
        textures[static_cast<std::size_t>(clip.sourceFrame(f).value)] = {.file = resolvePath(path, folder)};
    }
    return TextureSet::perFrame(std::move(textures));
}

} // namespace quadrille
