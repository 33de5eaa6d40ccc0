// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/file.h"
#include "model/sequence/io/files/numbertext.h"
#include "model/sequence/io/mesh/meshwriter.h"
#include "model/sequence/io/mesh/obj.h"

namespace quadrille {

namespace {

/// Vertices change from frame to frame; what is before and behind them is the same text in all files, but for
/// the material library where textures change.
class ObjFrameWriter : public FrameWriter
{
public:
    ObjFrameWriter(const MeshSequence& sequence, const std::string& stem, CopiedTextures textures,
                   StagedFiles& files)
        : m_topology(sequence.topology), m_stem(stem), m_textures(std::move(textures))
    {
        const TopologyData& data = m_topology->data();
        m_materials = data.materials;
        const bool hasLibrary = !m_textures.ofFrames.empty() || !m_textures.ofMaterials.empty();
        if (m_materials.empty() && hasLibrary)
            m_materials.emplace_back("material");
        if (hasLibrary && m_textures.ofFrames.empty())
            writeAtomically(files.add(m_stem + ".mtl"), library(0));
        m_faces = faces(data);
    }

    std::string write(const WrittenFrame& frame, StagedFiles& files) const override
    {
        std::string text = "# Quadrille\n";
        constexpr std::size_t bytesPerVertex = 36;
        text.reserve(text.size() + frame.positions.size() * bytesPerVertex + m_faces.size() + 64);
        if (!m_textures.ofFrames.empty()) {
            writeAtomically(files.add(frame.stem + ".mtl"), library(frame.number));
            text.append("mtllib ").append(frame.stem).append(".mtl\n");
        } else if (!m_textures.ofMaterials.empty()) {
            text.append("mtllib ").append(m_stem).append(".mtl\n");
        }
        text.append("o ").append(m_stem).append("\n");
        for (const Vec3f& p : frame.positions) {
            text += 'v';
            for (int axis = 0; axis < 3; ++axis) {
                text += ' ';
                appendNumber(text, p[axis]);
            }
            text += '\n';
        }
        return text += m_faces;
    }

private:
    std::string library(std::int64_t frame) const
    {
        std::string text = "# Quadrille\n";
        for (std::size_t m = 0; m < m_materials.size(); ++m) {
            text.append("newmtl ").append(m_materials[m]).append("\nKd 1 1 1\n");
            if (const std::string& picture = m_textures.of(frame, m); !picture.empty())
                text.append("map_Kd ").append(picture).append("\n");
        }
        return text;
    }

    std::string faces(const TopologyData& data) const
    {
        std::string text;
        for (const Vec2f& uv : data.uvs) {
            text += "vt ";
            appendNumber(text, uv.x());
            text += ' ';
            appendNumber(text, uv.y());
            text += '\n';
        }
        int material = -1;
        for (std::size_t t = 0; t < data.triangles.size(); ++t) {
            const int wanted = data.triangleMaterials.empty() ? 0 : data.triangleMaterials[t];
            if (!m_materials.empty() && wanted != material) {
                material = wanted;
                text.append("usemtl ").append(m_materials[static_cast<std::size_t>(material)]).append("\n");
            }
            text += 'f';
            for (std::size_t c = 0; c < 3; ++c) {
                text += ' ';
                appendNumber(text, std::uint64_t{data.triangles[t][c].value} + 1);
                if (!data.triangleUvs.empty()) {
                    text += '/';
                    appendNumber(text, std::uint64_t{data.triangleUvs[t][c]} + 1);
                }
            }
            text += '\n';
        }
        return text;
    }

    std::shared_ptr<const Topology> m_topology;
    std::string m_stem;
    CopiedTextures m_textures;
    std::vector<std::string> m_materials;
    std::string m_faces; ///< texture coordinates and faces
};

} // namespace

std::unique_ptr<Exporter> makeObjExporter()
{
    return makeMeshExporter(
        {.info = objFormat(),
         .start = [](const MeshSequence& sequence, const std::string& stem, CopiedTextures textures,
                     StagedFiles& files) -> std::unique_ptr<FrameWriter> {
             return std::make_unique<ObjFrameWriter>(sequence, stem, std::move(textures), files);
         }});
}

} // namespace quadrille
