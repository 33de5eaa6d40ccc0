// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/copytextures.h"

#include "model/core/file.h"
#include "model/sequence/io/files/exporttexture.h"

#include <algorithm>
#include <map>

namespace quadrille {

namespace {

class Copier
{
public:
    Copier(const MeshSequence& sequence, const std::string& stem, StagedFiles& files)
        : m_sequence(sequence), m_stem(stem), m_files(files)
    {
    }

    std::string copyOfFrame(std::int64_t frame)
    {
        std::string number = std::to_string(frame);
        number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
        const FrameIndex source = m_sequence.sourceFrame(FrameIndex(frame));
        return copy(source.value, m_sequence.textures.indexFor(source), "textures/" + m_stem + "/" + number);
    }

    std::string copyOfMaterial(int material)
    {
        const int index = m_sequence.textures.indexFor(m_sequence.sourceFrame(FrameIndex(0)), material);
        const std::size_t copied = m_nameOf.size();
        return copy(index, index, m_stem + "_texture" + (copied == 0 ? "" : std::to_string(copied + 1)));
    }

private:
    /// \param key  what is copied once: frames of the source, materials.
    /// \return the name with its ending; that of the first copy where a picture was copied before.
    std::string copy(std::int64_t key, int index, std::string name)
    {
        if (index < 0)
            return {};
        const Texture& texture = m_sequence.textures.textures()[static_cast<std::size_t>(index)];
        if (texture.isEmpty())
            return {};
        if (const auto known = m_nameOf.find(key); known != m_nameOf.end())
            return known->second;
        const EncodedTexture encoded = encodeTexture(texture);
        name += encoded.extension;
        writeAtomically(
            m_files.add(name),
            std::string_view(reinterpret_cast<const char*>(encoded.bytes.data()), encoded.bytes.size()));
        return m_nameOf[key] = name;
    }

    const MeshSequence& m_sequence;
    const std::string& m_stem;
    StagedFiles& m_files;
    std::map<std::int64_t, std::string> m_nameOf;
};

} // namespace

const std::string& CopiedTextures::of(std::int64_t frame, std::size_t material) const
{
    static const std::string none;
    if (!ofFrames.empty())
        return ofFrames[static_cast<std::size_t>(frame)];
    return material < ofMaterials.size() ? ofMaterials[material] : none;
}

CopiedTextures copyTextures(const MeshSequence& sequence, const std::string& stem, StagedFiles& files,
                            const Progress& progress)
{
    CopiedTextures copied;
    if (sequence.textures.kind() == TextureSet::Kind::None)
        return copied;
    Copier copier(sequence, stem, files);
    if (sequence.textures.kind() == TextureSet::Kind::PerFrame) {
        for (std::int64_t frame = 0; frame < sequence.frameCount(); ++frame) {
            progress.report(frame, sequence.frameCount());
            copied.ofFrames.push_back(copier.copyOfFrame(frame));
        }
        return copied;
    }
    const auto materials =
        static_cast<int>(std::max<std::size_t>(1, sequence.topology->data().materials.size()));
    for (int material = 0; material < materials; ++material) {
        progress.report(material, materials);
        copied.ofMaterials.push_back(copier.copyOfMaterial(material));
    }
    return copied;
}

} // namespace quadrille
