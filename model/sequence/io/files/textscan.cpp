// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/textscan.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace

std::string_view takeLine(std::string_view& text)
{
    const auto end = std::min(text.find('\n'), text.size());
    const auto line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

std::string_view takeWord(std::string_view& line)
{
    line = trimmed(line);
    const auto end = std::min(line.find_first_of(blanks), line.size());
    const auto word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

std::int64_t lineOf(std::string_view text, const char* at)
{
    return 1 + std::count(text.data(), at, '\n');
}

void throwSyntax(const std::filesystem::path& file, std::string_view text, const char* at, std::string reason)
{
    throw Error(ErrorCode::FileSyntax, {file, {.line = lineOf(text, at)}, {{"reason", std::move(reason)}}});
}

std::string_view checkedText(std::string_view text, const std::filesystem::path& file)
{
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const bool isWide = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    const auto zero = text.find('\0');
    if (isWide || zero != std::string_view::npos) {
        throw Error(ErrorCode::FileEncoding,
                    {file, {.byte = isWide ? 0 : static_cast<std::int64_t>(zero)}, {}});
    }
    return text;
}

} // namespace quadrille
