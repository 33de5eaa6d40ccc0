// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace quadrille {

/// The place of a frame's number in a file name: "####" or "%04d", as in sources so in exports.
struct NumberHolder
{
    std::size_t at = 0;
    std::size_t length = 0;
    std::size_t digits = 1; ///< at least so many are written; any number of them is read
};
/// The first one of a name; empty when it has none.
std::optional<NumberHolder> numberHolder(std::string_view name);

/// A file name that has a number in it, cut there. What is written as a series without a place for the number
/// gets it behind the name: "walk.obj" is "walk_" + number + ".obj".
struct SeriesName
{
    std::string before;
    std::string after;
    std::size_t digits = 4;

    std::string numbered(std::int64_t number) const;
};
SeriesName seriesName(const std::filesystem::path& out);

/// The file of one frame, from 0 on: "walk_0007.png" for "walk.png" and for "walk_####.png". Without a place
/// for the number at least four digits; always as many as `count` files need.
std::string numberedName(const std::filesystem::path& out, std::int64_t number, std::int64_t count);

/// The name that all files of a series share: without ending, number and what separates it; "walk" for
/// "walk_####.obj" and for "walk.obj".
std::string seriesStem(const std::filesystem::path& out);

} // namespace quadrille
