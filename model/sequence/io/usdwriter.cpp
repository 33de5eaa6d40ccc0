// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/usdwriter.h"

#include "model/core/file.h"
#include "model/sequence/io/files/copytextures.h"
#include "model/sequence/io/files/numbertext.h"

#include <array>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <set>
#include <type_traits>

namespace quadrille {

namespace {

template <typename Number>
requires std::is_arithmetic_v<Number>
void append(std::string& text, Number number)
{
    appendNumber(text, number);
}

void append(std::string& text, const Vec3f& v)
{
    text += '(';
    append(text, v.x());
    text += ", ";
    append(text, v.y());
    text += ", ";
    append(text, v.z());
    text += ')';
}

void append(std::string& text, const Vec2f& v)
{
    text += '(';
    append(text, v.x());
    text += ", ";
    append(text, v.y());
    text += ')';
}

template <typename Range>
void appendList(std::string& text, const Range& values)
{
    text += '[';
    bool isFirst = true;
    for (const auto& value : values) {
        text += isFirst ? "" : ", ";
        append(text, value);
        isFirst = false;
    }
    text += ']';
}

/// A name as USD allows it: letters, digits and underscores, not beginning with a digit.
std::string primName(const std::string& name, const std::string& fallback)
{
    std::string result;
    for (const char c : name)
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (result.empty())
        return fallback;
    return std::isdigit(static_cast<unsigned char>(result.front())) != 0 ? "_" + result : result;
}

class UsdFile
{
public:
    UsdFile(const MeshSequence& sequence, const ExportOptions& options, const std::filesystem::path& out)
        : m_sequence(sequence)
        , m_options(options)
        , m_out(out)
        , m_root(primName(sequence.name, "sequence"))
        , m_topology(sequence.topology->data())
    {
        const std::size_t count = std::max<std::size_t>(1, m_topology.materials.size());
        std::set<std::string> taken;
        for (std::size_t m = 0; m < count; ++m) {
            const std::string wanted =
                primName(m < m_topology.materials.size() ? m_topology.materials[m] : "", "material");
            std::string name = wanted;
            for (int suffix = 2; !taken.insert(name).second; ++suffix)
                name = wanted + "_" + std::to_string(suffix);
            m_materialNames.push_back(std::move(name));
        }
    }

    ExportResult write(const Progress& progress)
    {
        StagedFiles files(m_out.parent_path(), m_options.guard);
        if (m_options.textures)
            m_textures = copyTextures(m_sequence, m_out.stem().string(), files, progress.part(0, 0.2));
        std::ofstream file(files.add(m_out.filename().string()), std::ios::binary);
        flush(file, header());
        flush(file, meshStart());
        writeFrames(file, progress.part(0.2, 1));
        flush(file, meshEnd() + materials() + "}\n");
        file.close();
        check(file);
        return {files.commit(), {}};
    }

private:
    void check(const std::ofstream& file) const
    {
        if (!file)
            throwSystemError(m_out, errno, ErrorCode::WriteFailed);
    }

    void flush(std::ofstream& file, const std::string& text) const
    {
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        check(file);
    }

    std::string header() const
    {
        std::string text = "#usda 1.0\n(\n    defaultPrim = \"" + m_root + "\"\n    metersPerUnit = ";
        append(text, m_options.to.metresPerUnit);
        text += "\n    upAxis = \"";
        text += m_options.to.up == UpAxis::Z ? 'Z' : 'Y';
        text += "\"\n    startTimeCode = 0\n    endTimeCode = ";
        append(text, m_sequence.frameCount() - 1);
        text += "\n    timeCodesPerSecond = ";
        append(text, m_sequence.fps);
        text += "\n    framesPerSecond = ";
        append(text, m_sequence.fps);
        return text + "\n)\n\n";
    }

    std::string meshStart() const
    {
        std::string text =
            "def Xform \"" + m_root +
            "\" (\n    kind = \"component\"\n)\n{\n    def Mesh \"mesh\" (\n"
            "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {\n"
            "        uniform token subdivisionScheme = \"none\"\n        int[] faceVertexCounts = ";
        appendList(text, std::vector<std::int64_t>(m_topology.triangles.size(), 3));
        text += "\n        int[] faceVertexIndices = ";
        std::vector<std::int64_t> corners;
        for (const Triangle& triangle : m_topology.triangles)
            for (const VertexIndex v : triangle)
                corners.push_back(v.value);
        appendList(text, corners);
        text += '\n';
        if (!m_topology.triangleUvs.empty()) {
            text += "        texCoord2f[] primvars:st = ";
            appendList(text, m_topology.uvs);
            text += " (\n            interpolation = \"faceVarying\"\n        )\n        int[] "
                    "primvars:st:indices = ";
            corners.clear();
            for (const auto& triangle : m_topology.triangleUvs)
                corners.insert(corners.end(), triangle.begin(), triangle.end());
            appendList(text, corners);
            text += '\n';
        }
        return text;
    }

    void writeFrames(std::ofstream& file, const Progress& progress) const
    {
        const std::int64_t frames = m_sequence.frameCount();
        std::string extents = "        float3[] extent.timeSamples = {\n";
        flush(file, "        point3f[] points.timeSamples = {\n");
        for (std::int64_t f = 0; f < frames; ++f) {
            progress.report(f, frames);
            const Frame frame = m_sequence.frame(FrameIndex(f));
            const Positions positions = frame.positions();
            std::string line = "            " + std::to_string(f) + ": ";
            std::array<Vec3f, 2> extent{positions[0], positions[0]};
            for (const Vec3f& p : positions) {
                extent[0] = extent[0].cwiseMin(p);
                extent[1] = extent[1].cwiseMax(p);
            }
            extents += line;
            appendList(extents, extent);
            extents += ",\n";
            appendList(line, positions);
            flush(file, line + ",\n");
        }
        flush(file, "        }\n" + extents + "        }\n");
    }

    /// Triangles of each material as subsets, or one binding for all.
    std::string meshEnd() const
    {
        const auto binding = [&](std::size_t material) {
            return "rel material:binding = </" + m_root + "/materials/" + m_materialNames[material] + ">\n";
        };
        std::string text;
        if (m_materialNames.size() == 1)
            return "        " + binding(0) + "    }\n\n";
        text += "        uniform token subsetFamily:materialBind:familyType = \"partition\"\n";
        for (std::size_t m = 0; m < m_materialNames.size(); ++m) {
            std::vector<std::int64_t> triangles;
            for (std::size_t t = 0; t < m_topology.triangles.size(); ++t) {
                if ((m_topology.triangleMaterials.empty() ? 0 : m_topology.triangleMaterials[t]) == m)
                    triangles.push_back(static_cast<std::int64_t>(t));
            }
            text += "\n        def GeomSubset \"" + m_materialNames[m] +
                    "\" (\n            prepend apiSchemas = [\"MaterialBindingAPI\"]\n        )\n        {\n"
                    "            uniform token elementType = \"face\"\n"
                    "            uniform token familyName = \"materialBind\"\n            int[] indices = ";
            appendList(text, triangles);
            text += "\n            " + binding(m) + "        }\n";
        }
        return text + "    }\n\n";
    }

    std::string materials() const
    {
        std::string text = "    def Scope \"materials\"\n    {\n";
        for (std::size_t m = 0; m < m_materialNames.size(); ++m)
            text += material(m);
        return text + "    }\n";
    }

    std::string texturePath(std::size_t material) const
    {
        const auto& frames = m_textures.ofFrames;
        if (!frames.empty()) {
            std::string text = "asset inputs:file.timeSamples = {\n";
            for (std::size_t f = 0; f < frames.size(); ++f)
                text += "                    " + std::to_string(f) + ": @./" + frames[f] + "@,\n";
            return text + "                }\n";
        }
        const std::string& picture = m_textures.of(0, material);
        return picture.empty() ? std::string() : "asset inputs:file = @./" + picture + "@\n";
    }

    std::string material(std::size_t index) const
    {
        const std::string path = "/" + m_root + "/materials/" + m_materialNames[index];
        const std::string picture = texturePath(index);
        std::string text = "        def Material \"" + m_materialNames[index] +
                           "\"\n        {\n            token outputs:surface.connect = <" + path +
                           "/surface.outputs:surface>\n\n            def Shader \"surface\"\n            {\n"
                           "                uniform token info:id = \"UsdPreviewSurface\"\n"
                           "                float inputs:roughness = 1\n";
        text += picture.empty() ? "                color3f inputs:diffuseColor = (0.7, 0.7, 0.7)\n"
                                : "                color3f inputs:diffuseColor.connect = <" + path +
                                      "/texture.outputs:rgb>\n";
        text += "                token outputs:surface\n            }\n";
        if (!picture.empty()) {
            text += "\n            def Shader \"texture\"\n            {\n"
                    "                uniform token info:id = \"UsdUVTexture\"\n                " +
                    picture +
                    "                token inputs:sourceColorSpace = \"sRGB\"\n"
                    "                token inputs:wrapS = \"repeat\"\n                token inputs:wrapT = "
                    "\"repeat\"\n"
                    "                float2 inputs:st.connect = <" +
                    path +
                    "/uv.outputs:result>\n                float3 outputs:rgb\n            }\n\n"
                    "            def Shader \"uv\"\n            {\n"
                    "                uniform token info:id = \"UsdPrimvarReader_float2\"\n"
                    "                string inputs:varname = \"st\"\n"
                    "                float2 outputs:result\n            }\n";
        }
        return text + "        }\n";
    }

    const MeshSequence& m_sequence;
    const ExportOptions& m_options;
    const std::filesystem::path& m_out;
    std::string m_root;
    const TopologyData& m_topology;
    std::vector<std::string> m_materialNames; ///< as prims, at least one
    CopiedTextures m_textures;
};

} // namespace

const FormatInfo& UsdExporter::format() const
{
    static const FormatInfo info{
        .id = "usd", .name = "USD (text)", .extensions = {".usda", ".usd"}, .texturesBeside = true};
    return info;
}

ExportResult UsdExporter::write(const MeshSequence& sequence, const std::filesystem::path& out,
                                const ExportOptions& options, const Progress& progress) const
{
    if (options.to.up == UpAxis::X) {
        throw Error(ErrorCode::FormatCannotStore,
                    {out, {}, {{"format", "USD"}, {"what", "a world with x up"}}});
    }
    return UsdFile(sequence, options, out).write(progress);
}

} // namespace quadrille
