// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/files/sourcefiles.h"

#include "model/core/error.h"
#include "model/core/file.h"
#include "model/core/seriesname.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fnmatch.h>
#include <map>
#include <system_error>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// A file name cut at one of its numbers.
struct NumberedName
{
    std::string before;
    std::int64_t number = 0;
    std::string after; ///< with the extension

    std::string key() const { return before + '\0' + after; }
};

/// The name cut at each of its numbers, the last number first; numbers beyond 18 digits are passed over.
std::vector<NumberedName> cutAtNumbers(const std::string& name)
{
    const std::size_t end = name.size() - fs::path(name).extension().string().size();
    std::vector<NumberedName> cuts;
    for (std::size_t last = end; last > 0;) {
        if (!isDigit(name[last - 1])) {
            --last;
            continue;
        }
        std::size_t first = last;
        while (first > 0 && isDigit(name[first - 1]))
            --first;
        NumberedName cut{name.substr(0, first), 0, name.substr(last)};
        const auto parsed = std::from_chars(name.data() + first, name.data() + last, cut.number);
        if (parsed.ec == std::errc())
            cuts.push_back(std::move(cut));
        last = first;
    }
    return cuts;
}

std::vector<std::string> fileNames(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
         !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored))
            names.push_back(entry->path().filename().string());
    }
    if (error)
        throwSystemError(folder, error.value(), ErrorCode::ReadFailed);
    std::sort(names.begin(), names.end(), naturalLess);
    return names;
}

/// Gaps beyond this are not listed one by one: such numbers are time stamps.
constexpr std::size_t missingAtMost = 100'000;

std::vector<std::int64_t> gapsIn(const std::vector<std::int64_t>& numbers)
{
    std::vector<std::int64_t> gaps;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        for (auto n = numbers[i - 1] + 1; n < numbers[i] && gaps.size() < missingAtMost; ++n)
            gaps.push_back(n);
    }
    return gaps;
}

std::string trimmedStem(const std::string& before, const std::string& after)
{
    std::string stem = before + fs::path(after).stem().string();
    if (after.starts_with('.'))
        stem = before;
    while (!stem.empty() && std::string_view("_-. ").find(stem.back()) != std::string_view::npos)
        stem.pop_back();
    return stem;
}

SourceFiles makeSeries(const fs::path& path, const fs::path& folder, std::vector<NumberedName> cuts,
                       const std::map<std::int64_t, std::string>& nameByNumber)
{
    SourceFiles source;
    source.path = path;
    source.stem = trimmedStem(cuts.front().before, cuts.front().after);
    for (const auto& [number, name] : nameByNumber) {
        source.numbers.push_back(number);
        source.files.push_back(folder / name);
    }
    source.missing = gapsIn(source.numbers);
    return source;
}

SourceFiles makeSingle(const fs::path& file)
{
    return {.path = file, .files = {file}, .stem = file.stem().string()};
}

/// Groups names whose cut at one number leaves the same rest; each name goes with its largest group, and with
/// its last number where groups are equally large.
FolderContent group(const fs::path& path, const fs::path& folder, const std::vector<std::string>& names)
{
    std::map<std::string, std::size_t> sizes;
    for (const auto& name : names) {
        for (const auto& cut : cutAtNumbers(name))
            ++sizes[cut.key()];
    }
    struct Group
    {
        std::vector<NumberedName> cuts;
        std::map<std::int64_t, std::string> names;
    };
    std::map<std::string, Group> groups;
    std::vector<std::string> order;
    FolderContent content;
    for (const auto& name : names) {
        const auto cuts = cutAtNumbers(name);
        const auto best = std::max_element(cuts.begin(), cuts.end(), [&](const auto& a, const auto& b) {
            return sizes.at(a.key()) < sizes.at(b.key());
        });
        if (best == cuts.end() || sizes.at(best->key()) < 2) {
            content.singles.push_back(makeSingle(folder / name));
            continue;
        }
        auto& members = groups[best->key()];
        if (members.cuts.empty())
            order.push_back(best->key());
        members.cuts.push_back(*best);
        const auto [other, isNew] = members.names.emplace(best->number, name);
        if (!isNew) {
            throw Error(ErrorCode::SeriesAmbiguous,
                        {path, {}, {{"found", other->second + " and " + name + " have the same number"}}});
        }
    }
    for (const auto& key : order) {
        auto& members = groups.at(key);
        if (members.cuts.size() == 1)
            content.singles.push_back(makeSingle(folder / members.names.begin()->second));
        else
            content.series.push_back(makeSeries(path, folder, std::move(members.cuts), members.names));
    }
    return content;
}

std::string describeFound(const FolderContent& content)
{
    std::vector<std::string> found;
    for (const auto& series : content.series) {
        found.push_back("a series of " + std::to_string(series.files.size()) + " files from " +
                        series.files.front().filename().string() + " to " +
                        series.files.back().filename().string());
    }
    for (const auto& single : content.singles)
        found.push_back("the file " + single.files.front().filename().string());
    std::string text;
    constexpr std::size_t atMost = 5;
    for (std::size_t i = 0; i < std::min(found.size(), atMost); ++i)
        text += (i == 0 ? "" : ", ") + found[i];
    if (found.size() > atMost)
        text += " and " + std::to_string(found.size() - atMost) + " more";
    return text;
}

/// The number of a file that a pattern with a place for it means; empty when the file does not fit.
std::optional<std::int64_t> numberIn(const std::string& file, const SeriesName& pattern)
{
    if (file.size() <= pattern.before.size() + pattern.after.size() || !file.starts_with(pattern.before) ||
        !file.ends_with(pattern.after))
        return std::nullopt;
    std::int64_t number = 0;
    const char* const end = file.data() + file.size() - pattern.after.size();
    const auto parsed = std::from_chars(file.data() + pattern.before.size(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end || number < 0)
        return std::nullopt;
    return number;
}

} // namespace

std::string lowerExtension(const fs::path& path)
{
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

bool naturalLess(std::string_view a, std::string_view b)
{
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (!isDigit(a[i]) || !isDigit(b[j])) {
            if (a[i] != b[j])
                return a[i] < b[j];
            ++i;
            ++j;
            continue;
        }
        const auto digits = [](std::string_view text, std::size_t& at) {
            const std::size_t first = std::min(text.find_first_not_of('0', at), text.size());
            at = first;
            while (at < text.size() && isDigit(text[at]))
                ++at;
            return text.substr(first, at - first);
        };
        const auto left = digits(a, i);
        const auto right = digits(b, j);
        if (left.size() != right.size())
            return left.size() < right.size();
        if (left != right)
            return left < right;
    }
    if (a.size() - i != b.size() - j)
        return a.size() - i < b.size() - j;
    return a < b;
}

FolderContent scanFolder(const fs::path& folder, std::span<const std::string> extensions)
{
    auto names = fileNames(folder);
    std::erase_if(names, [&](const std::string& name) {
        return std::find(extensions.begin(), extensions.end(), lowerExtension(name)) == extensions.end();
    });
    return group(folder, folder, names);
}

SourceFiles onlySeries(FolderContent content, const fs::path& path)
{
    if (content.series.empty() && content.singles.empty())
        throw Error(ErrorCode::SeriesEmpty, {path, {}, {}});
    if (content.series.empty() && content.singles.size() == 1)
        return std::move(content.singles.front());
    if (content.series.size() != 1)
        throw Error(ErrorCode::SeriesAmbiguous, {path, {}, {{"found", describeFound(content)}}});
    return std::move(content.series.front());
}

bool isPattern(const fs::path& path)
{
    const std::string name = path.filename().string();
    return name.find_first_of("*?[#") != std::string::npos || numberHolder(name).has_value();
}

bool matchesPattern(const std::string& file, const std::string& pattern)
{
    if (numberHolder(pattern))
        return numberIn(file, seriesName(pattern)).has_value();
    return ::fnmatch(pattern.c_str(), file.c_str(), FNM_PERIOD) == 0;
}

SourceFiles findPattern(const fs::path& pattern)
{
    const fs::path folder = pattern.parent_path();
    const std::string name = pattern.filename().string();
    auto names = fileNames(folder);
    if (numberHolder(name)) {
        const SeriesName holder = seriesName(name);
        std::vector<NumberedName> cuts;
        std::map<std::int64_t, std::string> nameByNumber;
        for (const auto& file : names) {
            const auto number = numberIn(file, holder);
            if (!number)
                continue;
            cuts.push_back({holder.before, *number, holder.after});
            nameByNumber.emplace(*number, file);
        }
        if (cuts.empty())
            throw Error(ErrorCode::SeriesEmpty, {pattern, {}, {}});
        return makeSeries(pattern, folder, std::move(cuts), nameByNumber);
    }
    std::erase_if(names, [&](const std::string& file) { return !matchesPattern(file, name); });
    auto content = group(pattern, folder, names);
    if (content.series.empty() && content.singles.size() == 1)
        return makeSingle(content.singles.front().files.front());
    if (!content.series.empty() && !content.singles.empty())
        throw Error(ErrorCode::SeriesAmbiguous, {pattern, {}, {{"found", describeFound(content)}}});
    return onlySeries(std::move(content), pattern);
}

std::string describeNumbers(std::span<const std::int64_t> numbers)
{
    constexpr int spansAtMost = 12;
    std::string text;
    int spans = 0;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
            ++last;
        text += spans == 0 ? "" : ", ";
        if (spans++ == spansAtMost)
            return text + "…";
        text += std::to_string(numbers[i]);
        if (last > i)
            text += (last > i + 1 ? "–" : ", ") + std::to_string(numbers[last]);
        i = last + 1;
    }
    return text;
}

} // namespace quadrille
