// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/mesh/mtl.h"

#include "model/sequence/io/files/textscan.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace quadrille {

namespace fs = std::filesystem;

namespace {

/// Options of texture maps with their smallest number of values; -o, -s and -t take up to three numbers.
struct MapOption
{
    std::string_view name;
    int values;
    bool moreNumbers;
};
constexpr std::array mapOptions{
    MapOption{"-blendu", 1, false}, MapOption{"-blendv", 1, false},  MapOption{"-boost", 1, false},
    MapOption{"-mm", 2, false},     MapOption{"-o", 1, true},        MapOption{"-s", 1, true},
    MapOption{"-t", 1, true},       MapOption{"-texres", 1, false},  MapOption{"-clamp", 1, false},
    MapOption{"-bm", 1, false},     MapOption{"-imfchan", 1, false}, MapOption{"-type", 1, false},
    MapOption{"-cc", 1, false},
};

bool startsWithNumber(std::string_view text)
{
    auto rest = text;
    const auto word = takeWord(rest);
    float ignored = 0;
    return !rest.empty() &&
           scanNumber(word.data(), word.data() + word.size(), ignored) == word.data() + word.size();
}

std::string_view withoutOptions(std::string_view line)
{
    while (line.starts_with('-')) {
        auto rest = line;
        const auto name = takeWord(rest);
        const auto option = std::find_if(mapOptions.begin(), mapOptions.end(),
                                         [name](const MapOption& o) { return o.name == name; });
        if (option == mapOptions.end())
            return line;
        for (int i = 0; i < option->values; ++i)
            takeWord(rest);
        for (int i = 0; option->moreNumbers && i < 2 && startsWithNumber(rest); ++i)
            takeWord(rest);
        line = rest;
    }
    return line;
}

std::string lower(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool isFile(const fs::path& path)
{
    std::error_code error;
    return fs::is_regular_file(path, error);
}

} // namespace

std::map<std::string, std::string> readColourMaps(std::string_view text)
{
    std::map<std::string, std::string> maps;
    std::string material;
    while (!text.empty()) {
        auto line = takeLine(text);
        const auto keyword = lower(std::string(takeWord(line)));
        if (keyword == "newmtl")
            material = line;
        else if (keyword == "map_kd" && !withoutOptions(line).empty())
            maps[material] = withoutOptions(line);
    }
    return maps;
}

fs::path resolveNamedFile(const fs::path& folder, std::string name)
{
    if (name.size() > 1 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path named(name);
    for (const fs::path& candidate : {folder / named, folder / named.filename()}) {
        if (isFile(candidate))
            return candidate;
    }
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end;
         !error && entry != end; entry.increment(error)) {
        if (lower(entry->path().filename().string()) == lower(named.filename().string()) &&
            isFile(entry->path()))
            return entry->path();
    }
    return {};
}

} // namespace quadrille
