// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/appendbytes.h"
#include "model/sequence/io/mesh/meshwriter.h"
#include "model/sequence/io/mesh/ply.h"

#include <array>
#include <bit>

namespace quadrille {

namespace {

static_assert(std::endian::native == std::endian::little, "binary PLY is written as it lies in memory");

class PlyFrameWriter : public FrameWriter
{
public:
    PlyFrameWriter(const MeshSequence& sequence, CopiedTextures textures)
        : m_topology(sequence.topology), m_textures(std::move(textures)), m_faces(faces())
    {
    }

    std::string write(const WrittenFrame& frame, StagedFiles& /*files*/) const override
    {
        std::string text = header(frame.number);
        const std::size_t bytes = frame.positions.size() * sizeof(Vec3f);
        text.reserve(text.size() + bytes + m_faces.size());
        text.append(reinterpret_cast<const char*>(frame.positions.data()), bytes);
        return text += m_faces;
    }

private:
    const TopologyData& data() const { return m_topology->data(); }
    bool hasMaterials() const
    {
        return m_textures.ofMaterials.size() > 1 && !data().triangleMaterials.empty();
    }

    std::string header(std::int64_t frame) const
    {
        std::string text = "ply\nformat binary_little_endian 1.0\ncomment Quadrille\n";
        const std::size_t pictures = hasMaterials() ? m_textures.ofMaterials.size() : 1;
        for (std::size_t m = 0; m < pictures; ++m) {
            // A material without a picture keeps its number.
            if (const std::string& picture = m_textures.of(frame, m); !picture.empty() || hasMaterials())
                text.append("comment TextureFile ").append(picture.empty() ? "none" : picture).append("\n");
        }
        text.append("element vertex ").append(std::to_string(m_topology->vertexCount()));
        text += "\nproperty float x\nproperty float y\nproperty float z\nelement face ";
        text.append(std::to_string(data().triangles.size()));
        text += "\nproperty list uchar int vertex_indices\n";
        if (!data().triangleUvs.empty())
            text += "property list uchar float texcoord\n";
        if (hasMaterials())
            text += "property int texnumber\n";
        return text += "end_header\n";
    }

    std::string faces() const
    {
        std::string text;
        for (std::size_t t = 0; t < data().triangles.size(); ++t) {
            text += '\3';
            for (const VertexIndex vertex : data().triangles[t])
                appendBytes(text, static_cast<std::int32_t>(vertex.value));
            if (!data().triangleUvs.empty()) {
                text += '\6';
                for (const std::uint32_t uv : data().triangleUvs[t])
                    for (const float coordinate : data().uvs[uv])
                        appendBytes(text, coordinate);
            }
            if (hasMaterials())
                appendBytes(text, std::int32_t{data().triangleMaterials[t]});
        }
        return text;
    }

    std::shared_ptr<const Topology> m_topology;
    CopiedTextures m_textures;
    std::string m_faces;
};

} // namespace

std::unique_ptr<Exporter> makePlyExporter()
{
    return makeMeshExporter(
        {.info = plyFormat(),
         .start = [](const MeshSequence& sequence, const std::string& /*stem*/, CopiedTextures textures,
                     StagedFiles& /*files*/) -> std::unique_ptr<FrameWriter> {
             return std::make_unique<PlyFrameWriter>(sequence, std::move(textures));
         }});
}

} // namespace quadrille
