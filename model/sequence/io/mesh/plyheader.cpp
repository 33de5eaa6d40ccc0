// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/plyheader.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace quadrille {

namespace {

std::optional<PlyType> typeNamed(std::string_view name)
{
    static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{
        {"char", PlyType::Int8},
        {"int8", PlyType::Int8},
        {"uchar", PlyType::UInt8},
        {"uint8", PlyType::UInt8},
        {"short", PlyType::Int16},
        {"int16", PlyType::Int16},
        {"ushort", PlyType::UInt16},
        {"uint16", PlyType::UInt16},
        {"int", PlyType::Int32},
        {"int32", PlyType::Int32},
        {"uint", PlyType::UInt32},
        {"uint32", PlyType::UInt32},
        {"float", PlyType::Float32},
        {"float32", PlyType::Float32},
        {"double", PlyType::Float64},
        {"float64", PlyType::Float64},
    }};
    const auto* const found =
        std::find_if(names.begin(), names.end(), [name](const auto& each) { return each.first == name; });
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

class HeaderParser
{
public:
    HeaderParser(std::string_view content, const std::filesystem::path& file)
        : m_content(content), m_rest(content), m_file(file)
    {
    }

    PlyHeader parse()
    {
        if (takeHeaderLine() != "ply")
            fail(QUADRILLE_MESSAGE("it does not begin with “ply”"));
        bool hasFormat = false;
        for (;;) {
            if (m_rest.empty())
                fail(QUADRILLE_MESSAGE("the header has no end_header"));
            std::string_view line = takeHeaderLine();
            const auto keyword = takeWord(line);
            if (keyword == "end_header")
                break;
            if (keyword == "format") {
                parseFormat(line);
                hasFormat = true;
            } else if (keyword == "element") {
                parseElement(line);
            } else if (keyword == "property") {
                parseProperty(line);
            } else if (keyword == "comment") {
                if (takeWord(line) == "TextureFile" && !line.empty())
                    m_header.textures.emplace_back(line);
            } else if (keyword != "obj_info" && !keyword.empty()) {
                fail("the header has a line “" + std::string(keyword) + "”");
            }
        }
        if (!hasFormat)
            fail(QUADRILLE_MESSAGE("the header names no format"));
        m_header.size = m_content.size() - m_rest.size();
        checkCounts();
        return std::move(m_header);
    }

private:
    std::string_view takeHeaderLine()
    {
        m_line = m_rest.data();
        return takeLine(m_rest);
    }
    [[noreturn]] void fail(std::string reason) const
    {
        throwSyntax(m_file, m_content, m_line, std::move(reason));
    }

    void parseFormat(std::string_view line)
    {
        const auto name = takeWord(line);
        if (name == "ascii")
            m_header.encoding = PlyHeader::Encoding::Ascii;
        else if (name == "binary_little_endian")
            m_header.encoding = PlyHeader::Encoding::LittleEndian;
        else if (name == "binary_big_endian")
            m_header.encoding = PlyHeader::Encoding::BigEndian;
        else
            fail("the format “" + std::string(name) + "” is not known");
    }

    void parseElement(std::string_view line)
    {
        PlyElement& element = m_header.elements.emplace_back();
        element.name = takeWord(line);
        const char* const end = line.data() + line.size();
        if (scanNumber(line.data(), end, element.count) != end || line.empty() || element.count < 0)
            fail(QUADRILLE_MESSAGE("the count of an element is not a number"));
    }

    PlyType takeType(std::string_view& line) const
    {
        const auto name = takeWord(line);
        const auto type = typeNamed(name);
        if (!type)
            fail("the type “" + std::string(name) + "” is not known");
        return *type;
    }

    void parseProperty(std::string_view line)
    {
        if (m_header.elements.empty())
            fail(QUADRILLE_MESSAGE("a property comes before any element"));
        PlyProperty property;
        if (std::string_view rest = line; takeWord(rest) == "list") {
            line = rest;
            property.countType = takeType(line);
            if (*property.countType >= PlyType::Float32)
                fail(QUADRILLE_MESSAGE("the length of a list is not an integer"));
        }
        property.type = takeType(line);
        property.name = line;
        if (property.name.empty())
            fail(QUADRILLE_MESSAGE("a property has no name"));
        m_header.elements.back().properties.push_back(std::move(property));
    }

    void checkCounts() const
    {
        std::uint64_t left = m_rest.size();
        for (const PlyElement& element : m_header.elements) {
            // In text a value takes a character and what separates it from the next one.
            const std::uint64_t each = m_header.encoding == PlyHeader::Encoding::Ascii
                                           ? 2 * element.properties.size()
                                           : element.bytes();
            const auto count = static_cast<std::uint64_t>(element.count);
            // A text file may end without a separator.
            if (each > 0 && count > (left + 1) / each) {
                throw Error(ErrorCode::CountTooLarge, {m_file,
                                                       {},
                                                       {{"count", std::to_string(element.count)},
                                                        {"what", "elements called " + element.name}}});
            }
            left -= std::min(left, each * count);
        }
    }

    std::string_view m_content;
    std::string_view m_rest;
    const char* m_line = nullptr;
    const std::filesystem::path& m_file;
    PlyHeader m_header;
};

} // namespace

std::size_t sizeOf(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
        return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
        return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
        return 4;
    case PlyType::Float64:
        return 8;
    }
    return 0;
}

bool PlyElement::hasLists() const
{
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& each) { return each.countType.has_value(); });
}

std::size_t PlyElement::bytes() const
{
    return std::transform_reduce(
        properties.begin(), properties.end(), std::size_t{0}, std::plus{},
        [](const PlyProperty& each) { return sizeOf(each.countType.value_or(each.type)); });
}

int PlyElement::find(std::initializer_list<std::string_view> names) const
{
    for (const std::string_view wanted : names) {
        const auto found = std::find_if(properties.begin(), properties.end(),
                                        [wanted](const PlyProperty& each) { return each.name == wanted; });
        if (found != properties.end())
            return static_cast<int>(found - properties.begin());
    }
    return -1;
}

PlyVertexColumns::PlyVertexColumns(const PlyElement& element)
    : axes{element.find({"x"}), element.find({"y"}), element.find({"z"})}
    , uv{element.find({"texture_u", "s", "u", "texcoord_u"}),
         element.find({"texture_v", "t", "v", "texcoord_v"})}
{
}

PlyHeader parsePlyHeader(std::string_view content, const std::filesystem::path& file)
{
    return HeaderParser(content, file).parse();
}

} // namespace quadrille
