// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Positions of the frames of an OBJ series. Numbers of vertices are parsed; faces and texture coordinates are
// compared as text with those of the first file, block by block, which costs next to nothing. Whatever is not
// exactly alike is left to the parser.
#include "model/sequence/io/files/textscan.h"
#include "model/sequence/io/mesh/obj.h"

#include <cstring>

namespace quadrille {

namespace {

/// What a line is, by its first characters.
enum class LineKind
{
    Vertex,
    Compared, ///< a face or a texture coordinate
    Skipped,
    Unsure,
};

LineKind kindOf(const char* at, const char* end)
{
    const char second = at + 1 < end ? at[1] : '\n';
    switch (*at) {
    case 'v':
        if (second == ' ')
            return LineKind::Vertex;
        return second == 't' ? LineKind::Compared : second == 'n' ? LineKind::Skipped : LineKind::Unsure;
    case 'f':
        return second == ' ' ? LineKind::Compared : LineKind::Unsure;
    case '#':
    case 'o':
    case 'g':
    case 's':
    case 'u':
    case 'm':
    case 'l':
    case '\n':
    case '\r':
        return LineKind::Skipped;
    default:
        return LineKind::Unsure;
    }
}

/// The place behind a line, or null when the line goes on behind its end.
const char* behindLine(const char* at, const char* end)
{
    const char* const next = nextLine(at, end);
    const char* last = next;
    while (last != at && (last[-1] == '\n' || last[-1] == '\r'))
        --last;
    return last != at && last[-1] == '\\' ? nullptr : next;
}

/// Lines of one kind that follow each other, and how many vertices stand before them: negative indices count
/// from there.
struct Block
{
    std::string text; ///< without the last line end
    std::size_t verticesBefore = 0;
};

class ObjPositionReader : public PositionReader
{
public:
    /// \return false when files like this one cannot be read by comparing.
    bool learn(std::string_view text, std::size_t vertexCount)
    {
        const char* at = text.data();
        const char* const end = at + text.size();
        std::size_t vertices = 0;
        while (at != end) {
            const auto kind = kindOf(at, end);
            const char* const next = behindLine(at, end);
            if (kind == LineKind::Unsure || !next)
                return false;
            if (kind == LineKind::Vertex)
                ++vertices;
            if (kind == LineKind::Compared)
                addLine({at, static_cast<std::size_t>(next - at)}, vertices);
            m_wasCompared = kind == LineKind::Compared;
            at = next;
        }
        for (Block& block : m_blocks)
            block.text.erase(block.text.find_last_not_of("\r\n") + 1);
        return vertices == vertexCount;
    }

    bool read(std::string_view content, MutablePositions out) const override
    {
        const char* at = content.data();
        const char* const end = at + content.size();
        std::size_t vertices = 0;
        std::size_t block = 0;
        while (at != end) {
            switch (kindOf(at, end)) {
            case LineKind::Vertex:
                if (vertices == out.size())
                    return false;
                at = readVertex(at + 2, end, out[vertices++]);
                break;
            case LineKind::Compared:
                if (block == m_blocks.size() || m_blocks[block].verticesBefore != vertices)
                    return false;
                at = behindBlock(at, end, m_blocks[block++].text);
                break;
            case LineKind::Skipped:
                at = behindLine(at, end);
                break;
            case LineKind::Unsure:
                return false;
            }
            if (!at)
                return false;
        }
        return vertices == out.size() && block == m_blocks.size();
    }

private:
    void addLine(std::string_view line, std::size_t vertices)
    {
        if (!m_wasCompared)
            m_blocks.push_back({{}, vertices});
        m_blocks.back().text += line;
    }

    static const char* readVertex(const char* at, const char* end, Vec3f& position)
    {
        for (int axis = 0; axis < 3; ++axis) {
            at = skipBlanks(at, end);
            at = scanNumber(at, end, position[axis]);
            if (!at)
                return nullptr;
        }
        if (at != end && *at == '\n') [[likely]]
            return at + 1;
        if (at != end && *at != ' ' && *at != '\t' && *at != '\r' && *at != '#')
            return nullptr;
        return behindLine(at, end);
    }

    static const char* behindBlock(const char* at, const char* end, const std::string& text)
    {
        if (static_cast<std::size_t>(end - at) < text.size() ||
            std::memcmp(at, text.data(), text.size()) != 0)
            return nullptr;
        at += text.size();
        if (at != end && *at == '\r')
            ++at;
        if (at == end)
            return at;
        return *at == '\n' ? at + 1 : nullptr;
    }

    std::vector<Block> m_blocks;
    bool m_wasCompared = false;
};

} // namespace

std::shared_ptr<const PositionReader> makeObjPositionReader(std::string_view content, const MeshFile& mesh)
{
    auto reader = std::make_shared<ObjPositionReader>();
    return reader->learn(content, mesh.positions.size()) ? reader : nullptr;
}

} // namespace quadrille
