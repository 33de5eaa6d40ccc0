// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/npy.h"

#include "model/core/error.h"
#include "model/core/message.h"

#include <charconv>

namespace quadrille {

namespace {

constexpr std::string_view signature = "\x93NUMPY";

[[noreturn]] void fail(const std::filesystem::path& file, std::string reason)
{
    throw Error(ErrorCode::FileSyntax, {file, {.byte = 0}, {{"reason", std::move(reason)}}});
}

/// The text of a value in the dictionary of the header, from its first character on.
std::string_view valueOf(std::string_view dictionary, std::string_view key, const std::filesystem::path& file)
{
    auto at = dictionary.find("'" + std::string(key) + "'");
    if (at != std::string_view::npos)
        at = dictionary.find(':', at);
    if (at != std::string_view::npos)
        at = dictionary.find_first_not_of(" \t", at + 1);
    if (at == std::string_view::npos)
        fail(file, "the header has no “" + std::string(key) + "”");
    return dictionary.substr(at);
}

std::vector<std::int64_t> parseShape(std::string_view text, const std::filesystem::path& file)
{
    std::vector<std::int64_t> shape;
    if (!text.starts_with('('))
        fail(file, QUADRILLE_MESSAGE("the shape is not a list of numbers"));
    for (text.remove_prefix(1);;) {
        text.remove_prefix(std::min(text.find_first_not_of(" ,"), text.size()));
        if (text.starts_with(')'))
            return shape;
        std::int64_t extent = 0;
        const auto parsed = std::from_chars(text.data(), text.data() + text.size(), extent);
        if (parsed.ec != std::errc() || extent < 0)
            fail(file, QUADRILLE_MESSAGE("the shape is not a list of numbers"));
        shape.push_back(extent);
        text.remove_prefix(static_cast<std::size_t>(parsed.ptr - text.data()));
    }
}

} // namespace

NpyHeader parseNpyHeader(std::string_view head, const std::filesystem::path& file)
{
    if (!head.starts_with(signature))
        fail(file, QUADRILLE_MESSAGE("it does not begin with \\x93NUMPY"));
    const auto byte = [&](std::size_t at) {
        return at < head.size() ? static_cast<std::size_t>(static_cast<unsigned char>(head[at])) : 0;
    };
    const std::size_t version = byte(signature.size());
    if (version < 1 || version > 3)
        fail(file, "version " + std::to_string(version) + " is not known");
    const std::size_t begin = version == 1 ? 10 : 12;
    std::size_t length = byte(8) | (byte(9) << 8U);
    if (version > 1)
        length |= (byte(10) << 16U) | (byte(11) << 24U);
    if (head.size() < begin + length) {
        throw Error(ErrorCode::FileTruncated,
                    {file,
                     {.byte = static_cast<std::int64_t>(head.size())},
                     {{"expected", "a header of " + std::to_string(length) + " bytes"},
                      {"found", std::to_string(head.size())}}});
    }
    const std::string_view dictionary = head.substr(begin, length);
    NpyHeader header;
    header.size = begin + length;
    header.isFortranOrder = valueOf(dictionary, "fortran_order", file).starts_with("True");
    header.shape = parseShape(valueOf(dictionary, "shape", file), file);
    if (auto type = valueOf(dictionary, "descr", file); type.starts_with('\'')) {
        type.remove_prefix(1);
        header.type = type.substr(0, type.find('\''));
    }
    return header;
}

std::string npyHeader(const std::string& description, std::span<const std::int64_t> shape)
{
    std::string dictionary = "{'descr': " + description + ", 'fortran_order': False, 'shape': (";
    for (const std::int64_t extent : shape)
        dictionary.append(std::to_string(extent)).append(", ");
    dictionary += "), }";
    constexpr std::size_t prefix = 10; // signature, version, length
    dictionary.append(63 - (prefix + dictionary.size()) % 64, ' ').append("\n");
    std::string header(signature);
    header += '\1';
    header += '\0';
    header += static_cast<char>(dictionary.size() & 0xFFU);
    header += static_cast<char>(dictionary.size() >> 8U);
    return header += dictionary;
}

} // namespace quadrille
