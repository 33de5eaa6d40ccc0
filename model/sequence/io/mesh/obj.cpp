// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/obj.h"

#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/mesh/polygons.h"

#include <map>

namespace quadrille {

namespace {

bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

class ObjParser
{
public:
    ObjParser(std::string_view content, const std::filesystem::path& file)
        : m_file(file)
        , m_text(checkedText(content, file))
        , m_at(m_text.data())
        , m_end(m_text.data() + m_text.size())
    {
        m_mesh.positions.reserve(m_text.size() / 80);
    }

    MeshFile parse()
    {
        while (m_at != m_end) {
            m_line = m_at;
            skip();
            if (m_at != m_end)
                parseLine();
            m_at = m_at == m_end ? m_end : nextLine(m_at, m_end);
        }
        m_mesh.topology.vertexCount = static_cast<std::uint32_t>(m_mesh.positions.size());
        if (m_mesh.positions.empty())
            throw Error(ErrorCode::NoVertices, {m_file, {}, {}});
        checkRanges();
        m_polygons.finish(m_mesh.topology, m_file, m_mesh.issues);
        return std::move(m_mesh);
    }

private:
    /// Skips blanks and line continuations.
    void skip()
    {
        m_at = skipBlanks(m_at, m_end);
        while (m_at != m_end && *m_at == '\\') {
            const char* next = m_at + 1;
            if (next != m_end && *next == '\r')
                ++next;
            if (next == m_end || *next != '\n')
                return;
            m_at = skipBlanks(next + 1, m_end);
        }
    }
    bool atLineEnd() const { return m_at == m_end || *m_at == '\n' || *m_at == '\r' || *m_at == '#'; }
    bool takeKeyword(std::string_view keyword)
    {
        const auto rest = static_cast<std::size_t>(m_end - m_at);
        if (rest <= keyword.size() || !isBlank(m_at[keyword.size()]) ||
            std::string_view(m_at, keyword.size()) != keyword)
            return false;
        m_at += keyword.size();
        return true;
    }
    std::string_view restOfLine() const
    {
        auto rest = std::string_view(m_at, static_cast<std::size_t>(m_end - m_at));
        return takeLine(rest);
    }
    [[noreturn]] void fail(std::string reason) const
    {
        throwSyntax(m_file, m_text, m_line, std::move(reason));
    }
    [[noreturn]] void failIndex(const char* what, std::int64_t index, std::size_t count,
                                const char* line) const
    {
        throw Error(ErrorCode::IndexOutOfRange,
                    {m_file,
                     {.line = lineOf(m_text, line)},
                     {{"what", what}, {"index", std::to_string(index)}, {"count", std::to_string(count)}}});
    }

    void parseLine()
    {
        if (takeKeyword("v")) {
            Vec3f& position = m_mesh.positions.emplace_back();
            for (int axis = 0; axis < 3; ++axis)
                position[axis] = takeNumber("a vertex needs three numbers");
        } else if (takeKeyword("vt")) {
            Vec2f& uv = m_mesh.topology.uvs.emplace_back(0, 0);
            uv[0] = takeNumber("a texture coordinate needs a number");
            skip();
            if (!atLineEnd())
                uv[1] = takeNumber("the second texture coordinate is not a number");
        } else if (takeKeyword("f")) {
            parseFace();
        } else if (takeKeyword("usemtl")) {
            m_material = restOfLine();
        } else if (takeKeyword("mtllib")) {
            m_mesh.materialLibraries.emplace_back(restOfLine());
        }
    }

    float takeNumber(const char* fallback)
    {
        skip();
        float value = 0;
        m_at = scanNumber(m_at, m_end, value);
        if (!m_at || !(atLineEnd() || isBlank(*m_at) || *m_at == '\\'))
            fail(fallback);
        return value;
    }

    /// Zero-based index of a one-based or, from the end, negative one.
    std::uint32_t takeIndex(const char* what, std::size_t count)
    {
        std::int64_t index = 0;
        const char* const behind = scanNumber(m_at, m_end, index);
        if (!behind)
            fail(std::string("a face names no ") + what + " here");
        m_at = behind;
        const auto known = static_cast<std::int64_t>(count);
        if (index == 0 || index < -known || index > std::int64_t{0xFFFFFFFE})
            failIndex(what, index, count, m_line);
        return static_cast<std::uint32_t>(index > 0 ? index - 1 : known + index);
    }

    void parseFace()
    {
        m_polygons.begin(materialIndex());
        for (skip(); !atLineEnd(); skip()) {
            const auto vertex = takeIndex("vertex", m_mesh.positions.size());
            auto uv = PolygonCollector::noUv;
            if (m_at != m_end && *m_at == '/') {
                ++m_at;
                if (m_at != m_end && *m_at != '/' && !isBlank(*m_at) && !atLineEnd())
                    uv = takeIndex("texture coordinate", m_mesh.topology.uvs.size());
                if (m_at != m_end && *m_at == '/') {
                    std::int64_t normal = 0;
                    const char* const behind = scanNumber(++m_at, m_end, normal);
                    m_at = behind ? behind : m_at;
                }
            }
            if (!atLineEnd() && !isBlank(*m_at) && *m_at != '\\')
                fail(QUADRILLE_MESSAGE("a corner of a face is not VERTEX/UV/NORMAL"));
            m_polygons.add(vertex, uv);
        }
        if (m_polygons.cornerCount() < 3)
            fail(QUADRILLE_MESSAGE("a face needs three corners"));
        m_polygons.end(m_mesh.topology);
        m_lineOfTriangle.resize(m_mesh.topology.triangles.size(), m_line);
    }

    std::uint16_t materialIndex()
    {
        if (m_mesh.topology.materials.empty() || m_material != m_currentMaterial) {
            const auto [known, isNew] = m_materials.emplace(m_material, m_mesh.topology.materials.size());
            if (isNew && known->second > 0xFFFF)
                fail(QUADRILLE_MESSAGE("there are more than 65,536 materials"));
            if (isNew)
                m_mesh.topology.materials.emplace_back(m_material);
            m_currentMaterial = m_material;
            m_currentIndex = static_cast<std::uint16_t>(known->second);
        }
        return m_currentIndex;
    }

    /// Faces may come before what they name, so that this waits for the end of the file.
    void checkRanges() const
    {
        const auto& topology = m_mesh.topology;
        for (std::size_t t = 0; t < topology.triangles.size(); ++t) {
            for (std::size_t c = 0; c < 3; ++c) {
                const auto vertex = topology.triangles[t][c].value;
                if (vertex >= topology.vertexCount)
                    failIndex("vertex", std::int64_t{vertex} + 1, topology.vertexCount, m_lineOfTriangle[t]);
                const auto uv = topology.triangleUvs[t][c];
                if (uv != PolygonCollector::noUv && uv >= topology.uvs.size()) {
                    failIndex("texture coordinate", std::int64_t{uv} + 1, topology.uvs.size(),
                              m_lineOfTriangle[t]);
                }
            }
        }
    }

    const std::filesystem::path& m_file;
    std::string_view m_text;
    const char* m_at;
    const char* m_end;
    const char* m_line = nullptr;
    MeshFile m_mesh;
    PolygonCollector m_polygons;
    std::vector<const char*> m_lineOfTriangle;
    std::string_view m_material;
    std::string_view m_currentMaterial;
    std::uint16_t m_currentIndex = 0;
    std::map<std::string, std::size_t, std::less<>> m_materials;
};

bool looksLikeObj(std::string_view head)
{
    while (!head.empty()) {
        const auto line = takeLine(head);
        if (line.empty() || line.starts_with('#'))
            continue;
        return line.starts_with("v ") || line.starts_with("mtllib ") || line.starts_with("o ");
    }
    return false;
}

} // namespace

MeshFile parseObj(std::string_view content, const std::filesystem::path& file)
{
    return ObjParser(content, file).parse();
}

const FormatInfo& objFormat()
{
    static const FormatInfo info{.id = "obj",
                                 .name = "Wavefront OBJ",
                                 .extensions = {".obj"},
                                 .onePerFrame = true,
                                 .texturesBeside = true};
    return info;
}

std::unique_ptr<Importer> makeObjImporter()
{
    return makeMeshImporter({.info = objFormat(),
                             .recognises = looksLikeObj,
                             .parse = parseObj,
                             .makePositionReader = makeObjPositionReader});
}

} // namespace quadrille
