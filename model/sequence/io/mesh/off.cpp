// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/off.h"

#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/mesh/polygons.h"

#include <algorithm>

namespace quadrille {

namespace {

class OffParser
{
public:
    OffParser(std::string_view content, const std::filesystem::path& file)
        : m_file(file), m_text(checkedText(content, file)), m_rest(m_text)
    {
    }

    MeshFile parse()
    {
        readKeyword();
        readCounts();
        for (std::int64_t v = 0; v < m_vertexCount; ++v)
            readVertex(v);
        for (std::int64_t f = 0; f < m_faceCount; ++f)
            readFace(f);
        m_polygons.finish(m_mesh.topology, m_file, m_mesh.issues);
        return std::move(m_mesh);
    }

private:
    [[noreturn]] void fail(std::string reason) const
    {
        throwSyntax(m_file, m_text, m_place, std::move(reason));
    }

    /// The next line with something in it; comments are left out. Empty at the end.
    std::string_view takeContentLine()
    {
        while (!m_rest.empty()) {
            m_place = m_rest.data();
            std::string_view line = takeLine(m_rest);
            line = line.substr(0, line.find('#'));
            line = line.substr(0, line.find_last_not_of(" \t") + 1);
            if (!line.empty())
                return line;
        }
        return {};
    }

    void readKeyword()
    {
        m_line = takeContentLine();
        std::string_view rest = m_line;
        std::string_view keyword = takeWord(rest);
        if (!keyword.ends_with("OFF"))
            return; // the first line may be left out
        keyword.remove_suffix(3);
        if (rest.starts_with("BINARY"))
            refuse("Binary OFF");
        if (keyword.find_first_of("4n") != std::string_view::npos)
            refuse("OFF in other than three dimensions");
        m_hasUvs = keyword.starts_with("ST");
        keyword.remove_prefix(m_hasUvs ? 2 : 0);
        m_hasColors = keyword.find('C') != std::string_view::npos;
        m_hasNormals = keyword.find('N') != std::string_view::npos;
        // Some writers leave out the line end behind the keyword.
        m_line = rest.empty() ? takeContentLine() : rest;
    }

    [[noreturn]] void refuse(const char* format) const
    {
        throw Error(
            ErrorCode::FormatRefused,
            {m_file,
             {},
             {{"format", format}, {"remedy", QUADRILLE_MESSAGE("Save it as text OFF, PLY or OBJ.")}}});
    }

    template <typename Number>
    Number takeNumber(std::string_view& line, const char* fallback) const
    {
        const auto word = takeWord(line);
        Number number{};
        const char* const end = word.data() + word.size();
        if (word.empty() || scanNumber(word.data(), end, number) != end)
            fail(fallback);
        return number;
    }

    void readCounts()
    {
        m_vertexCount = takeNumber<std::int64_t>(
            m_line, QUADRILLE_MESSAGE("the counts of vertices and faces are missing"));
        m_faceCount = takeNumber<std::int64_t>(m_line, QUADRILLE_MESSAGE("the count of faces is missing"));
        if (m_vertexCount == 0)
            throw Error(ErrorCode::NoVertices, {m_file, {}, {}});
        if (m_vertexCount < 0 || m_faceCount < 0)
            fail(QUADRILLE_MESSAGE("a count is negative"));
        // "0 0 0" and its line end; "3 0 1 2" and its line end.
        checkCount(m_vertexCount, 6, "vertices");
        checkCount(m_faceCount, 8, "faces");
        m_mesh.topology.vertexCount = static_cast<std::uint32_t>(m_vertexCount);
        m_mesh.positions.reserve(static_cast<std::size_t>(m_vertexCount));
    }

    void checkCount(std::int64_t count, std::size_t bytesEach, const char* what) const
    {
        if (static_cast<std::uint64_t>(count) <= (m_rest.size() + 1) / bytesEach)
            return;
        throw Error(ErrorCode::CountTooLarge,
                    {m_file, {}, {{"count", std::to_string(count)}, {"what", what}}});
    }

    std::string_view takeElement(std::int64_t at, std::int64_t count, const char* what)
    {
        const auto line = takeContentLine();
        if (!line.empty())
            return line;
        throw Error(ErrorCode::FileTruncated,
                    {m_file,
                     {.byte = static_cast<std::int64_t>(m_text.size())},
                     {{"expected", std::to_string(count) + " " + what}, {"found", std::to_string(at)}}});
    }

    void readVertex(std::int64_t at)
    {
        auto line = takeElement(at, m_vertexCount, "vertices");
        Vec3f& position = m_mesh.positions.emplace_back();
        for (int axis = 0; axis < 3; ++axis)
            position[axis] = takeNumber<float>(line, QUADRILLE_MESSAGE("a vertex needs three numbers"));
        if (!m_hasUvs)
            return;
        for (int skipped = (m_hasNormals ? 3 : 0) + (m_hasColors ? 4 : 0); skipped > 0; --skipped)
            takeNumber<float>(line, QUADRILLE_MESSAGE("a vertex has too few numbers"));
        const float u = takeNumber<float>(line, QUADRILLE_MESSAGE("a vertex has no texture coordinates"));
        m_mesh.topology.uvs.emplace_back(
            u, takeNumber<float>(line, QUADRILLE_MESSAGE("a vertex has no texture coordinates")));
    }

    void readFace(std::int64_t at)
    {
        auto line = takeElement(at, m_faceCount, "faces");
        const auto corners = takeNumber<std::int64_t>(
            line, QUADRILLE_MESSAGE("a face does not begin with its count of corners"));
        if (corners < 3)
            fail(QUADRILLE_MESSAGE("a face needs three corners"));
        m_polygons.begin();
        for (std::int64_t c = 0; c < corners; ++c) {
            const auto vertex =
                takeNumber<std::int64_t>(line, QUADRILLE_MESSAGE("a face has too few corners"));
            if (vertex < 0 || vertex >= m_vertexCount) {
                throw Error(ErrorCode::IndexOutOfRange, {m_file,
                                                         {.line = lineOf(m_text, m_place)},
                                                         {{"what", "vertex"},
                                                          {"index", std::to_string(vertex)},
                                                          {"count", std::to_string(m_vertexCount)}}});
            }
            const auto index = static_cast<std::uint32_t>(vertex);
            m_polygons.add(index, m_hasUvs ? index : PolygonCollector::noUv);
        }
        m_polygons.end(m_mesh.topology);
    }

    const std::filesystem::path& m_file;
    std::string_view m_text;
    std::string_view m_rest;
    std::string_view m_line;
    const char* m_place = m_text.data();
    std::int64_t m_vertexCount = 0;
    std::int64_t m_faceCount = 0;
    bool m_hasUvs = false;
    bool m_hasColors = false;
    bool m_hasNormals = false;
    MeshFile m_mesh;
    PolygonCollector m_polygons;
};

bool looksLikeOff(std::string_view head)
{
    const auto word = takeWord(head);
    return word == "OFF" || word == "COFF" || word == "NOFF" || word == "CNOFF" || word == "STOFF";
}

} // namespace

MeshFile parseOff(std::string_view content, const std::filesystem::path& file)
{
    return OffParser(content, file).parse();
}

std::unique_ptr<Importer> makeOffImporter()
{
    return makeMeshImporter(
        {.info = {.id = "off", .name = "OFF", .extensions = {".off"}, .onePerFrame = true},
         .recognises = looksLikeOff,
         .parse = parseOff});
}

} // namespace quadrille
