// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/codecs.h"
#include "model/project/fields/fieldinfo.h"
#include "model/project/fields/members.h"

#include <array>
#include <utility>

namespace quadrille {

// Each entry of the project file is described once, by describe(fields, Type<Entry>()): its members in the
// order in which they are written, with key, kind, place in the entry, range, sentence for the schema, and
// whether it must be there. What is done with them is the visitor's: reading, writing, checks, the schema,
// paths, references and memory. Defaults are those of a new entry.

/// The words of an enumeration, and what each means.
template <typename Value, std::size_t count>
constexpr std::array<std::pair<const char*, Value>, count>
words(const std::pair<const char*, Value> (&list)[count])
{
    return std::to_array(list);
}

/// The entry itself, where a member of it is asked for.
inline constexpr auto itself = [](auto& entry) -> auto&
{
    return entry;
};

inline constexpr auto ownCharacterHelp = "May be left out with one character.";
inline constexpr auto frameRateHelp = "Frames per second.";
inline constexpr auto shareReason = "The share must be above 0 and at most 1";

namespace limits {

inline constexpr Limits frameRate =
    Limits::between(0.001, 10000, "A frame rate must be from 0.001 to 10000 frames a second");
inline constexpr Limits alpha =
    Limits::from(0, "Alpha is below zero", "Write 0.01, or more to favour short walks.");
inline constexpr Limits length = Limits::from(0, nullptr);
inline constexpr Limits count = Limits::from(0, nullptr);
/// As far as a number of JSON is exact.
inline constexpr Limits seed =
    Limits::from(0, "The seed is below zero", "Write a whole number from 0.")
        .upTo(9007199254740991.0, {"The seed is above 9007199254740991", "Write a smaller one."});

constexpr Limits anHourFrom(const Limits& low)
{
    return low.upTo(
        3600, {"An animation lasts at most an hour, 3600 seconds", "Write an earlier time, in seconds."});
}
inline constexpr Limits duration = anHourFrom(Limits::above(0, "A duration must be above zero"));

inline constexpr Limits blendWeight =
    Limits::between(0, 1, "The weight of a blend must be from 0 to 1", "Write 0.5 for half of both.");

} // namespace limits

} // namespace quadrille
