// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/texture.h"

#include <map>
#include <utility>

namespace quadrille {

std::shared_ptr<const Image> Texture::load() const
{
    if (embedded)
        return embedded;
    return std::make_shared<const Image>(made ? made() : readImage(file, marks));
}

TextureSet::TextureSet(Kind kind, std::vector<Texture> textures)
    : m_kind(kind), m_textures(std::move(textures))
{
}

TextureSet TextureSet::single(Texture texture)
{
    return {Kind::Single, {std::move(texture)}};
}

TextureSet TextureSet::perFrame(std::vector<Texture> textures)
{
    TextureSet set(Kind::PerFrame, std::move(textures));
    std::map<std::pair<std::filesystem::path, ColourMarks>, int> firsts;
    set.m_firsts.reserve(set.m_textures.size());
    for (const Texture& texture : set.m_textures) {
        const int index = static_cast<int>(set.m_firsts.size());
        const bool isFile = !texture.embedded && !texture.made && !texture.isEmpty();
        set.m_firsts.push_back(isFile ? firsts.try_emplace({texture.file, texture.marks}, index).first->second
                                      : index);
    }
    return set;
}

TextureSet TextureSet::perMaterial(std::vector<Texture> textures)
{
    return {Kind::PerMaterial, std::move(textures)};
}

TextureSet TextureSet::blendedBy(std::shared_ptr<const TextureBlender> blender) const
{
    TextureSet blended = *this;
    blended.m_blender = std::move(blender);
    return blended;
}

int TextureSet::indexFor(FrameIndex sourceFrame, int material) const
{
    std::int64_t index = -1;
    switch (m_kind) {
    case Kind::None:
        break;
    case Kind::Single:
        index = 0;
        break;
    case Kind::PerFrame:
        index = sourceFrame.value >= 0 && sourceFrame.value < std::ssize(m_firsts)
                    ? m_firsts[static_cast<std::size_t>(sourceFrame.value)]
                    : -1;
        break;
    case Kind::PerMaterial:
        index = material;
        break;
    }
    const bool exists = index >= 0 && index < static_cast<std::int64_t>(m_textures.size()) &&
                        !m_textures[static_cast<std::size_t>(index)].isEmpty();
    return exists ? static_cast<int>(index) : -1;
}

std::shared_ptr<const Image> TextureSet::image(int index, MediaCache& cache) const
{
    if (index < 0)
        return nullptr;
    const Texture& texture = m_textures[static_cast<std::size_t>(index)];
    if (texture.embedded)
        return texture.embedded;
    if (texture.isEmpty())
        return nullptr;
    return std::static_pointer_cast<const Image>(cache.get(m_id, index, [&texture] {
        auto image = texture.load();
        const std::size_t bytes = image->pixels.size();
        return MediaCache::Loaded{std::move(image), bytes};
    }));
}

} // namespace quadrille
