// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/fbxgeometry.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <string_view>
#include <zlib.h>

namespace quadrille {

namespace {

constexpr std::string_view magic("Kaydara FBX Binary  \0\x1a\0", 23);
constexpr std::uint64_t largestPacking = 1100; // deflate

/// Reads values one after the other; out of range makes everything zero and `isGood` false.
class Cursor
{
public:
    Cursor(std::span<const std::byte> bytes, std::uint64_t at) : m_bytes(bytes), m_at(at) {}

    template <typename T>
    T get()
    {
        T value{};
        const auto bytes = take(sizeof(T));
        if (isGood)
            std::memcpy(&value, bytes.data(), sizeof(T));
        return value;
    }
    std::span<const std::byte> take(std::uint64_t count)
    {
        isGood = isGood && m_at <= m_bytes.size() && count <= m_bytes.size() - m_at;
        if (!isGood)
            return {};
        const auto taken = m_bytes.subspan(m_at, count);
        m_at += count;
        return taken;
    }
    std::uint64_t position() const { return m_at; }

    bool isGood = true;

private:
    std::span<const std::byte> m_bytes;
    std::uint64_t m_at;
};

struct Node
{
    std::string_view name;
    std::uint64_t propertyCount = 0;
    std::uint64_t propertiesAt = 0;
    std::uint64_t childrenAt = 0;
    std::uint64_t end = 0;
};

class Reader
{
public:
    Reader(std::span<const std::byte> bytes, std::uint32_t version) : m_bytes(bytes), m_wide(version >= 7500)
    {
    }

    void forEachNode(std::uint64_t from, std::uint64_t end,
                     const std::function<void(const Node&)>& visit) const
    {
        while (from < end) {
            Cursor cursor(m_bytes, from);
            const auto number = [&] {
                return m_wide ? cursor.get<std::uint64_t>() : std::uint64_t{cursor.get<std::uint32_t>()};
            };
            Node node;
            node.end = number();
            node.propertyCount = number();
            const std::uint64_t propertyBytes = number();
            const auto name = cursor.take(cursor.get<std::uint8_t>());
            if (!cursor.isGood || node.end <= from || node.end > end || propertyBytes > node.end - from)
                return;
            node.name = {reinterpret_cast<const char*>(name.data()), name.size()};
            node.propertiesAt = cursor.position();
            node.childrenAt = node.propertiesAt + propertyBytes;
            visit(node);
            from = node.end;
        }
    }

    /// The values of the array that is the node's first property.
    template <typename T>
    std::optional<std::vector<T>> array(const Node& node, char type) const
    {
        Cursor cursor(m_bytes, node.propertiesAt);
        const bool fits = node.propertyCount >= 1 && cursor.get<char>() == type;
        const std::uint64_t length = cursor.get<std::uint32_t>();
        const auto encoding = cursor.get<std::uint32_t>();
        const auto packed = cursor.take(cursor.get<std::uint32_t>());
        if (!fits || !cursor.isGood ||
            length * sizeof(T) > packed.size() * (encoding == 1 ? largestPacking : 1))
            return std::nullopt;
        if (length == 0)
            return std::vector<T>();
        std::vector<T> values(length);
        auto bytes = static_cast<uLongf>(length * sizeof(T));
        if (encoding == 0)
            std::memcpy(values.data(), packed.data(), bytes);
        else if (uncompress(reinterpret_cast<Bytef*>(values.data()), &bytes,
                            reinterpret_cast<const Bytef*>(packed.data()), packed.size()) != Z_OK ||
                 bytes != length * sizeof(T))
            return std::nullopt;
        return values;
    }

private:
    std::span<const std::byte> m_bytes;
    bool m_wide;
};

std::vector<double> readPoints(const Reader& reader, const Node& node)
{
    if (auto points = reader.array<double>(node, 'd'))
        return std::move(*points);
    const auto floats = reader.array<float>(node, 'f');
    return floats ? std::vector<double>(floats->begin(), floats->end()) : std::vector<double>();
}

PolygonGeometry readGeometry(const Reader& reader, const Node& geometry)
{
    PolygonGeometry result;
    reader.forEachNode(geometry.childrenAt, geometry.end, [&](const Node& child) {
        if (child.name == "Vertices") {
            result.controlPoints = readPoints(reader, child);
        } else if (child.name == "PolygonVertexIndex") {
            result.polygonVertices =
                reader.array<std::int32_t>(child, 'i').value_or(std::vector<std::int32_t>());
        } else if (child.name == "LayerElementMaterial" && result.polygonMaterials.empty()) {
            reader.forEachNode(child.childrenAt, child.end, [&](const Node& part) {
                if (part.name == "Materials")
                    result.polygonMaterials =
                        reader.array<std::int32_t>(part, 'i').value_or(std::vector<std::int32_t>());
            });
        }
    });
    return result;
}

} // namespace

std::vector<PolygonGeometry> readFbxGeometries(std::span<const std::byte> file)
{
    std::vector<PolygonGeometry> geometries;
    if (file.size() < 27 || std::memcmp(file.data(), magic.data(), magic.size()) != 0)
        return geometries;
    std::uint32_t version = 0;
    std::memcpy(&version, file.data() + 23, sizeof(version));
    const Reader reader(file, version);
    reader.forEachNode(27, file.size(), [&](const Node& top) {
        if (top.name != "Objects")
            return;
        reader.forEachNode(top.childrenAt, top.end, [&](const Node& object) {
            if (object.name != "Geometry")
                return;
            auto geometry = readGeometry(reader, object);
            if (!geometry.controlPoints.empty() && !geometry.polygonVertices.empty())
                geometries.push_back(std::move(geometry));
        });
    });
    return geometries;
}

} // namespace quadrille
