// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille::test {

/// A number whose highest byte comes first.
inline std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t count)
{
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes.at(at + i));
    return value;
}

/// The contents of all boxes of a type among others, one after the other.
inline std::vector<std::string_view> boxesOf(std::string_view bytes, std::string_view type)
{
    std::vector<std::string_view> found;
    while (bytes.size() >= 8) {
        std::size_t head = 8;
        std::size_t size = numberAt(bytes, 0, 4);
        if (size == 1) {
            size = numberAt(bytes, 8, 8);
            head = 16;
        }
        EXPECT_GE(size, head);
        EXPECT_LE(size, bytes.size());
        if (size < head || size > bytes.size())
            break;
        if (bytes.substr(4, 4) == type)
            found.push_back(bytes.substr(head, size - head));
        bytes.remove_prefix(size);
    }
    EXPECT_TRUE(bytes.empty());
    return found;
}

/// The one box at the end of a path such as "mdia/minf/stbl".
inline std::string_view boxOf(std::string_view bytes, std::string_view path)
{
    const std::size_t slash = path.find('/');
    const auto found = boxesOf(bytes, path.substr(0, slash));
    EXPECT_EQ(found.size(), 1U) << path;
    if (found.empty())
        return {};
    return slash == std::string_view::npos ? found.front() : boxOf(found.front(), path.substr(slash + 1));
}

/// The samples of a track of an MP4 file, as its tables say.
inline std::vector<std::string_view> samplesOf(std::string_view file, std::string_view track)
{
    const auto table = boxOf(track, "mdia/minf/stbl");
    const auto sizes = boxOf(table, "stsz");
    const auto chunks = boxOf(table, "co64");
    const auto runs = boxOf(table, "stsc");
    std::vector<std::string_view> samples;
    for (std::size_t chunk = 0; chunk < numberAt(chunks, 4, 4); ++chunk) {
        std::size_t count = 0;
        for (std::size_t run = 0; run < numberAt(runs, 4, 4); ++run) {
            if (chunk + 1 >= numberAt(runs, 8 + 12 * run, 4))
                count = numberAt(runs, 12 + 12 * run, 4);
        }
        std::size_t at = numberAt(chunks, 8 + 8 * chunk, 8);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t size = numberAt(sizes, 12 + 4 * samples.size(), 4);
            samples.push_back(file.substr(at, size));
            at += size;
        }
    }
    EXPECT_EQ(samples.size(), numberAt(sizes, 8, 4));
    return samples;
}

} // namespace quadrille::test
