// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// The text in quotation marks.
std::string quoted(const std::string& text);
/// "Did you mean …?" where a name is nearly one that exists, else the remedy.
std::string meantOr(const std::string& name, const std::vector<std::string>& known, std::string remedy);

/// The known word that a misspelt one probably stands for: at most two letters wrong, and fewer than half of
/// them.
std::optional<std::string> closestWord(std::string_view word, std::span<const std::string_view> known);

template <typename Entry>
std::vector<std::string> namesOf(const std::vector<Entry>& entries)
{
    std::vector<std::string> names(entries.size());
    std::transform(entries.begin(), entries.end(), names.begin(),
                   [](const Entry& entry) { return entry.name; });
    return names;
}

} // namespace quadrille
