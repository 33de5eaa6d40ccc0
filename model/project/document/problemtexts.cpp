// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/problemtexts.h"

#include <algorithm>
#include <cctype>

namespace quadrille {

namespace {

/// Letters of a key that count: "sourceFps", "source-fps" and "source_fps" are one word.
std::string lettersOf(std::string_view word)
{
    std::string letters;
    for (const char c : word) {
        if (c != '_' && c != '-' && c != ' ')
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return letters;
}

/// Letters to insert, delete, replace or exchange with their neighbour to get from one word to the other.
/// Cost: O(a · b).
std::size_t editDistance(std::string_view a, std::string_view b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const std::size_t different = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + different});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

} // namespace

std::optional<std::string> closestWord(std::string_view word, std::span<const std::string_view> known)
{
    if (word.size() > 64)
        return std::nullopt;
    const std::string letters = lettersOf(word);
    std::optional<std::string> best;
    std::size_t bestDistance = std::min<std::size_t>(3, (letters.size() + 1) / 2);
    for (const std::string_view candidate : known) {
        if (const auto distance = editDistance(letters, lettersOf(candidate)); distance < bestDistance) {
            bestDistance = distance;
            best = candidate;
        }
    }
    return best;
}

std::string quoted(const std::string& text)
{
    return "“" + text + "”";
}

std::string meantOr(const std::string& name, const std::vector<std::string>& known, std::string remedy)
{
    const std::vector<std::string_view> views(known.begin(), known.end());
    const auto meant = closestWord(name, views);
    return meant ? "Did you mean " + quoted(*meant) + "?" : std::move(remedy);
}

} // namespace quadrille
