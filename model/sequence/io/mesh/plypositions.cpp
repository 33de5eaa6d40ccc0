// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
// Positions of the frames of a PLY series: those of the vertices are taken, all behind them is compared with
// the first file byte by byte. Whatever is not exactly alike is left to the parser.
#include "model/sequence/io/mesh/ply.h"
#include "model/sequence/io/mesh/plyvalues.h"

namespace quadrille {

namespace {

/// What is behind the vertices, without the blanks at the end of a text.
std::string_view behind(std::string_view content, const char* place, bool isText)
{
    auto rest = content.substr(static_cast<std::size_t>(place - content.data()));
    if (isText)
        rest = rest.substr(0, rest.find_last_not_of(" \t\r\n") + 1);
    return rest;
}

class PlyPositionReader : public PositionReader
{
public:
    explicit PlyPositionReader(PlyHeader header) : m_header(std::move(header)), m_columns(vertices()) {}

    /// \return false when files like this one must be read whole.
    bool learn(std::string_view content)
    {
        const PlyElement& element = vertices();
        if (element.name != "vertex" || element.hasLists() || m_columns.hasUvs())
            return false;
        std::vector<Vec3f> positions(static_cast<std::size_t>(element.count));
        const char* const end = readVertices(m_header, content, positions);
        if (!end)
            return false;
        m_rest = behind(content, end, isText());
        return true;
    }

    bool read(std::string_view content, MutablePositions out) const override
    {
        const PlyHeader header = parsePlyHeader(content, {});
        if (!header.hasLayoutOf(m_header))
            return false;
        const char* const end = readVertices(header, content, out);
        return end && behind(content, end, isText()) == m_rest;
    }

private:
    const PlyElement& vertices() const { return m_header.elements.front(); }
    bool isText() const { return m_header.encoding == PlyHeader::Encoding::Ascii; }

    const char* readVertices(const PlyHeader& header, std::string_view content, MutablePositions out) const
    {
        const auto& properties = vertices().properties;
        if (isPlain())
            return copyVertices(header, content, out);
        return withPlyValues(header, content, [&](auto& values) -> const char* {
            std::vector<float> row(properties.size());
            for (Vec3f& position : out) {
                for (std::size_t p = 0; p < row.size(); ++p) {
                    if (!values.take(properties[p].type, row[p]))
                        return nullptr;
                }
                for (std::size_t axis = 0; axis < 3; ++axis)
                    position[static_cast<Eigen::Index>(axis)] =
                        row[static_cast<std::size_t>(m_columns.axes[axis])];
            }
            return values.place();
        });
    }

    /// Nearly all files: little endian, x, y and z as floats one after the other.
    bool isPlain() const
    {
        if (m_header.encoding != PlyHeader::Encoding::LittleEndian)
            return false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int column = m_columns.axes[axis];
            if (column != m_columns.axes[0] + static_cast<int>(axis) ||
                vertices().properties[static_cast<std::size_t>(column)].type != PlyType::Float32)
                return false;
        }
        return true;
    }

    const char* copyVertices(const PlyHeader& header, std::string_view content, MutablePositions out) const
    {
        const std::size_t stride = vertices().bytes();
        if (content.size() - header.size < stride * out.size())
            return nullptr;
        std::size_t offset = header.size;
        for (int p = 0; p < m_columns.axes[0]; ++p)
            offset += sizeOf(vertices().properties[static_cast<std::size_t>(p)].type);
        const char* at = content.data() + offset;
        if (stride == sizeof(Vec3f)) {
            std::memcpy(out.data()->data(), at, stride * out.size());
        } else {
            for (Vec3f& position : out) {
                std::memcpy(position.data(), at, sizeof(Vec3f));
                at += stride;
            }
        }
        return content.data() + header.size + stride * out.size();
    }

    PlyHeader m_header;
    PlyVertexColumns m_columns;
    std::string m_rest;
};

} // namespace

std::shared_ptr<const PositionReader> makePlyPositionReader(std::string_view content,
                                                            const MeshFile& /*mesh*/)
{
    auto reader = std::make_shared<PlyPositionReader>(parsePlyHeader(content, {}));
    return reader->learn(content) ? reader : nullptr;
}

} // namespace quadrille
