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
        const int index = m_sequence.textures.indexFor(m_sequence.sourceFrame(FrameIndex(frame)));
        // Those of frames that have the same one, too: numbers without a gap are a series elsewhere.
        return write(index, "textures/" + m_stem + "/" + number);
    }

    std::string copyOfMaterial(int material)
    {
        const int index = m_sequence.textures.indexFor(m_sequence.sourceFrame(FrameIndex(0)), material);
        if (const auto known = m_nameOf.find(index); known != m_nameOf.end())
            return known->second;
        const std::size_t copied = m_nameOf.size();
        std::string name =
            write(index, m_stem + "_texture" + (copied == 0 ? "" : std::to_string(copied + 1)));
        if (!name.empty())
            m_nameOf[index] = name;
        return name;
    }

private:
    /// \return the name with its ending; empty where there is no texture.
    std::string write(int index, std::string name)
    {
        if (index < 0)
            return {};
        const Texture& texture = m_sequence.textures.textures()[static_cast<std::size_t>(index)];
        if (texture.isEmpty())
            return {};
        const EncodedTexture encoded = encodeTexture(texture);
        name += encoded.extension;
        writeAtomically(
            m_files.add(name),
            std::string_view(reinterpret_cast<const char*>(encoded.bytes.data()), encoded.bytes.size()));
        return name;
    }

    const MeshSequence& m_sequence;
    const std::string& m_stem;
    StagedFiles& m_files;
    std::map<int, std::string> m_nameOf; ///< of materials
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
