// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/image.h"
#include "model/core/mediacache.h"
#include "model/core/units.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace quadrille {

/// One texture: a file, or a picture embedded in a scene file.
struct Texture
{
    std::filesystem::path file;
    std::shared_ptr<const Image> embedded;

    bool isEmpty() const { return file.empty() && !embedded; }
};

/// The textures of a sequence: none, one, one per frame, or one per material. Cheap to copy; read when asked
/// for.
class TextureSet
{
public:
    enum class Kind
    {
        None,
        Single,
        PerFrame,
        PerMaterial,
    };

    TextureSet() = default;
    static TextureSet single(Texture texture);
    /// \param textures one for each frame of the source, in frame order.
    static TextureSet perFrame(std::vector<Texture> textures);
    /// \param textures one for each material of the topology; empty ones where a material has none.
    static TextureSet perMaterial(std::vector<Texture> textures);

    Kind kind() const { return m_kind; }
    const std::vector<Texture>& textures() const { return m_textures; }
    /// Index into `textures()` for a source frame and a material; −1 when there is none.
    int indexFor(FrameIndex sourceFrame, int material = 0) const;
    /// The picture, from the cache or read now; null when index is −1 or the texture empty.
    /// \throws Error what readImage throws.
    std::shared_ptr<const Image> image(int index, MediaCache& cache = *MediaCache::shared()) const;

private:
    TextureSet(Kind kind, std::vector<Texture> textures);

    Kind m_kind = Kind::None;
    std::vector<Texture> m_textures;
    MediaId m_id;
};

} // namespace quadrille
