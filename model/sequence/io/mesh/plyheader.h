// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

enum class PlyType
{
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float32,
    Float64,
};
std::size_t sizeOf(PlyType type);

struct PlyProperty
{
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> countType; ///< of a list; empty for a single value
    bool operator==(const PlyProperty&) const = default;
};

struct PlyElement
{
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Whether a property is a list, so that elements differ in length.
    bool hasLists() const;
    /// Bytes that an element takes in a binary file; with lists, at least.
    std::size_t bytes() const;
    /// Where a property with one of these names stands; −1 without any.
    int find(std::initializer_list<std::string_view> names) const;
    bool operator==(const PlyElement&) const = default;
};

/// Which properties of a vertex mean what; −1 where it has none.
struct PlyVertexColumns
{
    explicit PlyVertexColumns(const PlyElement& element);
    bool hasUvs() const { return uv[0] >= 0 && uv[1] >= 0; }

    std::array<int, 3> axes;
    std::array<int, 2> uv;
};

/// How a PLY file is laid out.
struct PlyHeader
{
    enum class Encoding
    {
        Ascii,
        LittleEndian,
        BigEndian,
    };

    Encoding encoding = Encoding::Ascii;
    std::vector<PlyElement> elements;
    std::vector<std::string> textures; ///< from "comment TextureFile NAME"
    std::size_t size = 0;              ///< bytes before the first element

    /// Whether a file with this header has its values in the same order and form; comments do not matter.
    bool hasLayoutOf(const PlyHeader& other) const
    {
        return encoding == other.encoding && elements == other.elements;
    }
};

/// Reads a header and holds its counts against the size of the file before anything is allocated.
/// \throws Error FileSyntax with the line, CountTooLarge.
PlyHeader parsePlyHeader(std::string_view content, const std::filesystem::path& file);

} // namespace quadrille
