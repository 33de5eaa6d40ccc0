// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/core/seriesname.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// More than any file system takes in a name means no width.
constexpr std::size_t digitsAtMost = 18;

} // namespace

std::optional<NumberHolder> numberHolder(std::string_view name)
{
    if (const auto hash = name.find('#'); hash != std::string_view::npos) {
        const std::size_t length = std::min(name.find_first_not_of('#', hash), name.size()) - hash;
        return NumberHolder{hash, length, length};
    }
    for (auto at = name.find('%'); at != std::string_view::npos; at = name.find('%', at + 1)) {
        std::size_t end = at + 1;
        while (end < name.size() && isDigit(name[end]))
            ++end;
        if (end == name.size() || name[end] != 'd')
            continue;
        std::size_t digits = 1;
        std::from_chars(name.data() + at + 1, name.data() + end, digits);
        return NumberHolder{at, end + 1 - at, std::clamp<std::size_t>(digits, 1, digitsAtMost)};
    }
    return std::nullopt;
}

std::string SeriesName::numbered(std::int64_t number) const
{
    std::string text = std::to_string(number);
    text.insert(0, digits - std::min(digits, text.size()), '0');
    return before + text + after;
}

SeriesName seriesName(const std::filesystem::path& out)
{
    const std::string name = out.filename().string();
    if (const auto holder = numberHolder(name))
        return {name.substr(0, holder->at), name.substr(holder->at + holder->length), holder->digits};
    return {out.stem().string() + "_", out.extension().string(), 4};
}

std::string numberedName(const std::filesystem::path& out, std::int64_t number, std::int64_t count)
{
    SeriesName name = seriesName(out);
    name.digits = std::max(name.digits, std::to_string(std::max<std::int64_t>(count - 1, 0)).size());
    return name.numbered(number);
}

std::string seriesStem(const std::filesystem::path& out)
{
    const std::string name = out.filename().string();
    const auto holder = numberHolder(name);
    if (!holder)
        return out.stem().string();
    const auto isSeparator = [](char c) {
        return std::string_view("_-. ").find(c) != std::string_view::npos;
    };
    std::string before = name.substr(0, holder->at);
    std::string after = name.substr(holder->at + holder->length);
    after.resize(std::min(after.rfind('.'), after.size()));
    while (!before.empty() && isSeparator(before.back()))
        before.pop_back();
    while (before.empty() && !after.empty() && isSeparator(after.front()))
        after.erase(0, 1);
    const std::string stem = before + after;
    return stem.empty() ? "frames" : stem;
}

} // namespace quadrille
