// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/stl.h"

#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/mesh/polygons.h"

#include <array>
#include <bit>
#include <cstring>
#include <unordered_map>

namespace quadrille {

namespace {

constexpr std::size_t stlHeaderBytes = 84; ///< of a binary file: 80 free ones and the count
constexpr std::size_t triangleBytes = 50;

struct PlaceHash
{
    std::size_t operator()(const std::array<std::uint32_t, 3>& key) const noexcept
    {
        std::uint64_t hash = key[0];
        hash = (hash ^ key[1]) * 0x9e3779b97f4a7c15ULL;
        hash = (hash ^ (hash >> 29U) ^ key[2]) * 0xbf58476d1ce4e5b9ULL;
        return static_cast<std::size_t>(hash ^ (hash >> 32U));
    }
};

/// Makes a mesh of loose triangles.
class Joiner
{
public:
    void add(const std::array<Vec3f, 3>& corners)
    {
        m_polygons.begin();
        for (const Vec3f& corner : corners)
            m_polygons.add(indexOf(corner));
        m_polygons.end(m_mesh.topology);
        m_cornerCount += 3;
    }

    MeshFile finish(const std::filesystem::path& file)
    {
        m_mesh.topology.vertexCount = static_cast<std::uint32_t>(m_mesh.positions.size());
        m_polygons.finish(m_mesh.topology, file, m_mesh.issues);
        m_mesh.issues.push_back(
            {Issue::Severity::Info,
             Issue::Code::VerticesWelded,
             {file,
              {},
              {{"from", std::to_string(m_cornerCount)}, {"to", std::to_string(m_mesh.positions.size())}}}});
        return std::move(m_mesh);
    }

private:
    std::uint32_t indexOf(const Vec3f& place)
    {
        std::array<std::uint32_t, 3> key{};
        for (int axis = 0; axis < 3; ++axis) // −0 and 0 are one place
            key.at(static_cast<std::size_t>(axis)) = std::bit_cast<std::uint32_t>(place[axis] + 0.0F);
        const auto [known, isNew] =
            m_indices.emplace(key, static_cast<std::uint32_t>(m_mesh.positions.size()));
        if (isNew)
            m_mesh.positions.push_back(place);
        return known->second;
    }

    MeshFile m_mesh;
    PolygonCollector m_polygons;
    std::int64_t m_cornerCount = 0;
    std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, PlaceHash> m_indices;
};

std::uint32_t countOf(std::string_view content)
{
    std::uint32_t count = 0;
    if (content.size() >= stlHeaderBytes)
        std::memcpy(&count, content.data() + 80, sizeof count);
    return count;
}

/// Binary files may begin with "solid", too: their size tells.
bool isBinary(std::string_view content)
{
    const bool fits = content.size() == stlHeaderBytes + std::uint64_t{countOf(content)} * triangleBytes;
    return fits || !content.starts_with("solid") ||
           content.substr(0, stlHeaderBytes).find('\0') < stlHeaderBytes;
}

MeshFile parseBinary(std::string_view content, const std::filesystem::path& file)
{
    const auto truncated = [&](const std::string& expected, std::uint64_t found) {
        throw Error(ErrorCode::FileTruncated, {file,
                                               {.byte = static_cast<std::int64_t>(content.size())},
                                               {{"expected", expected}, {"found", std::to_string(found)}}});
    };
    if (content.size() < stlHeaderBytes)
        truncated("a header of 84 bytes", content.size());
    const std::uint32_t count = countOf(content);
    const std::uint64_t held = (content.size() - stlHeaderBytes) / triangleBytes;
    if (count > held) {
        // Far more than a cut-off copy explains: then it is no STL.
        if (count / 16 > held) {
            throw Error(ErrorCode::CountTooLarge,
                        {file, {.byte = 80}, {{"count", std::to_string(count)}, {"what", "triangles"}}});
        }
        truncated(std::to_string(count) + " triangles", held);
    }
    Joiner joiner;
    const char* at = content.data() + stlHeaderBytes;
    for (std::uint32_t t = 0; t < count; ++t, at += triangleBytes) {
        std::array<Vec3f, 3> corners;
        for (std::size_t c = 0; c < 3; ++c)
            std::memcpy(corners.at(c).data(), at + 12 * (c + 1), sizeof(Vec3f));
        joiner.add(corners);
    }
    return joiner.finish(file);
}

MeshFile parseText(std::string_view content, const std::filesystem::path& file)
{
    const std::string_view text = checkedText(content, file);
    std::string_view rest = text;
    Joiner joiner;
    std::array<Vec3f, 3> corners;
    std::size_t count = 0;
    bool hasEnd = false;
    const char* place = rest.data();
    while (!rest.empty()) {
        place = rest.data();
        std::string_view line = takeLine(rest);
        const auto keyword = takeWord(line);
        if (keyword == "vertex") {
            if (count == 3)
                throwSyntax(file, text, place, QUADRILLE_MESSAGE("a facet has more than three corners"));
            for (int axis = 0; axis < 3; ++axis) {
                const auto word = takeWord(line);
                const char* const end = word.data() + word.size();
                if (word.empty() || scanNumber(word.data(), end, corners.at(count)[axis]) != end)
                    throwSyntax(file, text, place, QUADRILLE_MESSAGE("a vertex needs three numbers"));
            }
            ++count;
        } else if (keyword == "endfacet") {
            if (count != 3)
                throwSyntax(file, text, place, QUADRILLE_MESSAGE("a facet has fewer than three corners"));
            joiner.add(corners);
            count = 0;
        } else if (keyword == "endsolid") {
            hasEnd = true;
        }
    }
    if (count != 0)
        throwSyntax(file, text, place, QUADRILLE_MESSAGE("the file ends within a facet"));
    if (!hasEnd) {
        throw Error(ErrorCode::FileTruncated,
                    {file,
                     {.line = lineOf(text, place)},
                     {{"expected", "“endsolid”"}, {"found", std::to_string(content.size()) + " bytes"}}});
    }
    return joiner.finish(file);
}

} // namespace

MeshFile parseStl(std::string_view content, const std::filesystem::path& file)
{
    return isBinary(content) ? parseBinary(content, file) : parseText(content, file);
}

std::unique_ptr<Importer> makeStlImporter()
{
    return makeMeshImporter(
        {.info = {.id = "stl", .name = "STL", .extensions = {".stl"}, .onePerFrame = true},
         .recognises = [](std::string_view head) { return head.starts_with("solid "); },
         .parse = parseStl});
}

} // namespace quadrille
