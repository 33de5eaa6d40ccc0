// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/ply.h"

#include "model/core/message.h"
#include "model/sequence/io/mesh/plyvalues.h"
#include "model/sequence/io/mesh/polygons.h"

#include <bit>
#include <unordered_map>

namespace quadrille {

namespace {

class PlyParser
{
public:
    PlyParser(std::string_view content, const std::filesystem::path& file)
        : m_content(content), m_file(file), m_header(parsePlyHeader(content, file))
    {
    }

    MeshFile parse()
    {
        if (m_header.encoding == PlyHeader::Encoding::Ascii)
            checkedText(m_content, m_file);
        m_mesh.textures = m_header.textures;
        for (const PlyElement& element : m_header.elements) {
            if (element.name == "vertex")
                m_mesh.topology.vertexCount = static_cast<std::uint32_t>(element.count);
            if (element.name == "tristrips")
                throwSyntax(m_file, m_content, m_content.data(),
                            QUADRILLE_MESSAGE("faces as triangle strips are not read"));
        }
        if (m_mesh.topology.vertexCount == 0)
            throw Error(ErrorCode::NoVertices, {m_file, {}, {}});
        withPlyValues(m_header, m_content, [this](auto& values) {
            for (const PlyElement& element : m_header.elements) {
                if (element.name == "vertex")
                    readVertices(element, values);
                else if (element.name == "face")
                    readFaces(element, values);
                else
                    skipElement(element, values);
            }
        });
        finishMaterials();
        m_polygons.finish(m_mesh.topology, m_file, m_mesh.issues);
        return std::move(m_mesh);
    }

private:
    template <typename Values>
    [[noreturn]] void fail(const PlyElement& element, std::int64_t at, const Values& values) const
    {
        const char* const place = values.place();
        const bool isText = m_header.encoding == PlyHeader::Encoding::Ascii;
        const bool isAtEnd =
            std::string_view(place, m_content.data() + m_content.size()).find_first_not_of(" \t\r\n") ==
            std::string_view::npos;
        if (isText && !isAtEnd)
            throwSyntax(m_file, m_content, place,
                        "a value of an element “" + element.name + "” is no number");
        throw Error(ErrorCode::FileTruncated,
                    {m_file,
                     {.byte = static_cast<std::int64_t>(m_content.size())},
                     {{"expected", std::to_string(element.count) + " elements called " + element.name},
                      {"found", std::to_string(at)}}});
    }

    template <typename Values>
    void skipProperty(const PlyElement& element, std::int64_t at, const PlyProperty& property, Values& values)
    {
        std::int64_t count = 1;
        if ((property.countType && !values.take(*property.countType, count)) || count < 0 ||
            !values.skip(property.type, count))
            fail(element, at, values);
    }

    template <typename Values>
    void skipElement(const PlyElement& element, Values& values)
    {
        if (element.properties.empty())
            return;
        for (std::int64_t i = 0; i < element.count; ++i) {
            for (const PlyProperty& property : element.properties)
                skipProperty(element, i, property, values);
        }
    }

    template <typename Values>
    void readVertices(const PlyElement& element, Values& values)
    {
        const PlyVertexColumns columns(element);
        if (std::any_of(columns.axes.begin(), columns.axes.end(), [](int column) { return column < 0; }))
            throwSyntax(m_file, m_content, m_content.data(),
                        QUADRILLE_MESSAGE("vertices have no x, y and z"));
        auto& positions = m_mesh.positions;
        positions.resize(static_cast<std::size_t>(element.count));
        if (columns.hasUvs())
            m_vertexUvs.resize(positions.size());
        std::vector<float> row(element.properties.size());
        for (std::int64_t v = 0; v < element.count; ++v) {
            for (std::size_t p = 0; p < row.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (property.countType)
                    skipProperty(element, v, property, values);
                else if (!values.take(property.type, row[p]))
                    fail(element, v, values);
            }
            const auto column = [&row](int index) { return row[static_cast<std::size_t>(index)]; };
            const auto at = static_cast<std::size_t>(v);
            positions[at] = {column(columns.axes[0]), column(columns.axes[1]), column(columns.axes[2])};
            if (columns.hasUvs())
                m_vertexUvs[at] = {column(columns.uv[0]), column(columns.uv[1])};
        }
    }

    template <typename Values>
    void readFaces(const PlyElement& element, Values& values)
    {
        const int corners = element.find({"vertex_indices", "vertex_index"});
        const int texcoords = element.find({"texcoord"});
        const int material = element.find({"texnumber"});
        if (corners < 0)
            throwSyntax(m_file, m_content, m_content.data(),
                        QUADRILLE_MESSAGE("faces have no vertex_indices"));
        for (std::int64_t f = 0; f < element.count; ++f) {
            m_corners.clear();
            m_cornerUvs.clear();
            std::int64_t number = 0;
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                const auto index = static_cast<int>(p);
                bool isRead = true;
                if (index == corners)
                    isRead = readList(property, values, m_corners);
                else if (index == texcoords)
                    isRead = readList(property, values, m_cornerUvs);
                else if (index == material && !property.countType)
                    isRead = values.take(property.type, number);
                else
                    skipProperty(element, f, property, values);
                if (!isRead)
                    fail(element, f, values);
            }
            addFace(f, number, values.place());
        }
    }

    template <typename Values, typename Number>
    bool readList(const PlyProperty& property, Values& values, std::vector<Number>& list) const
    {
        std::int64_t count = 1;
        if (property.countType && !values.take(*property.countType, count))
            return false;
        for (std::int64_t i = 0; i < count; ++i) {
            if (!values.take(property.type, list.emplace_back()))
                return false;
        }
        return count >= 0;
    }

    void addFace(std::int64_t face, std::int64_t material, const char* place)
    {
        ErrorPlace where;
        if (m_header.encoding == PlyHeader::Encoding::Ascii)
            where.line = lineOf(m_content, place);
        else
            where.byte = place - m_content.data();
        if (m_corners.size() < 3) {
            throw Error(ErrorCode::FileSyntax,
                        {m_file,
                         where,
                         {{"reason", "face " + std::to_string(face) + " has fewer than three corners"}}});
        }
        if (material < 0 || material > 0xFFFF)
            material = 0;
        m_highestMaterial = std::max(m_highestMaterial, material);
        m_polygons.begin(static_cast<std::uint16_t>(material));
        for (std::size_t c = 0; c < m_corners.size(); ++c) {
            const std::int64_t vertex = m_corners[c];
            if (vertex < 0 || vertex >= std::int64_t{m_mesh.topology.vertexCount}) {
                throw Error(ErrorCode::IndexOutOfRange,
                            {m_file,
                             where,
                             {{"what", "vertex"},
                              {"index", std::to_string(vertex)},
                              {"count", std::to_string(m_mesh.topology.vertexCount)}}});
            }
            m_polygons.add(static_cast<std::uint32_t>(vertex), uvOf(c, static_cast<std::size_t>(vertex)));
        }
        m_polygons.end(m_mesh.topology);
    }

    std::uint32_t uvOf(std::size_t corner, std::size_t vertex)
    {
        if (m_cornerUvs.size() >= 2 * m_corners.size())
            return indexOf({m_cornerUvs[2 * corner], m_cornerUvs[2 * corner + 1]});
        return m_vertexUvs.empty() ? PolygonCollector::noUv : indexOf(m_vertexUvs.at(vertex));
    }

    /// Corners with the same UV share it.
    std::uint32_t indexOf(const Vec2f& uv)
    {
        const auto key = (std::uint64_t{std::bit_cast<std::uint32_t>(uv.x())} << 32U) |
                         std::bit_cast<std::uint32_t>(uv.y());
        auto& uvs = m_mesh.topology.uvs;
        const auto [known, isNew] = m_uvIndices.emplace(key, static_cast<std::uint32_t>(uvs.size()));
        if (isNew)
            uvs.push_back(uv);
        return known->second;
    }

    /// Faces name their material by number; the textures of the header are theirs.
    void finishMaterials()
    {
        if (m_highestMaterial == 0)
            return;
        for (std::int64_t m = 0; m <= m_highestMaterial; ++m)
            m_mesh.topology.materials.push_back("material " + std::to_string(m));
        m_mesh.textures.resize(m_mesh.topology.materials.size());
    }

    std::string_view m_content;
    const std::filesystem::path& m_file;
    PlyHeader m_header;
    MeshFile m_mesh;
    PolygonCollector m_polygons;
    std::vector<Vec2f> m_vertexUvs;
    std::vector<std::int64_t> m_corners;
    std::vector<float> m_cornerUvs;
    std::unordered_map<std::uint64_t, std::uint32_t> m_uvIndices;
    std::int64_t m_highestMaterial = 0;
};

} // namespace

MeshFile parsePly(std::string_view content, const std::filesystem::path& file)
{
    return PlyParser(content, file).parse();
}

const FormatInfo& plyFormat()
{
    static const FormatInfo info{.id = "ply",
                                 .name = "Stanford PLY",
                                 .extensions = {".ply"},
                                 .onePerFrame = true,
                                 .texturesBeside = true};
    return info;
}

std::unique_ptr<Importer> makePlyImporter()
{
    return makeMeshImporter(
        {.info = plyFormat(),
         .recognises =
             [](std::string_view head) { return head.starts_with("ply\n") || head.starts_with("ply\r\n"); },
         .parse = parsePly,
         .makePositionReader = makePlyPositionReader});
}

} // namespace quadrille
