// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/problem.h"
#include "model/project/document/project.h"
#include "model/project/json/jsontext.h"

#include <initializer_list>
#include <span>
#include <utility>

namespace quadrille {

/// Reads the members of one object of a project file, each with a type check. Values of a wrong type are left
/// out and reported.
class ObjectReader
{
public:
    using Keys = std::span<const std::string_view>;

    ObjectReader(const Json& json, std::string pointer, ProjectProblems& problems);

    bool isObject() const { return m_json.is_object(); }
    /// A member; null where there is none.
    const Json* find(std::string_view key) const;
    const std::string& pointer() const { return m_pointer; }
    std::string pointer(std::string_view key) const;
    ProjectProblems& problems() const { return m_problems; }
    void invalid(const std::string& pointer, std::string reason, std::string remedy = {}) const;
    /// \param expected  "a number"
    void wrongType(std::string_view key, const std::string& expected) const;
    void missing(std::string_view key) const;

    std::string text(std::string_view key) const;
    std::string requiredText(std::string_view key) const;
    std::optional<double> number(std::string_view key) const;
    /// Above −\p below and below it; that must be 2⁵³ at most, up to which numbers of JSON are exact.
    std::optional<std::int64_t> wholeNumber(std::string_view key, double below = 2e9) const;
    bool boolean(std::string_view key, bool fallback) const;
    /// [first, last]
    std::optional<FrameRange> range(std::string_view key) const;
    /// As many numbers as `count`; any number of them where it is zero. \param expected  for the problem.
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count,
                                               const std::string& expected) const;
    /// A list of whole numbers from zero; empty where one is none.
    std::vector<int> wholeNumbers(std::string_view key) const;
    /// \param expected  what an item must be, a sentence.
    std::vector<std::string> texts(std::string_view key, const char* expected) const;
    /// “label”, or “sequence” with or without “range”; nothing where neither is there.
    std::optional<FrameChoice> choice() const;
    /// [[["walk", 12], ["kick", 40]], …]
    std::vector<JunctionEntry> junctions(std::string_view key) const;

    /// Calls `read(item, pointer)` for each item of an array member.
    template <typename Read>
    void each(std::string_view key, const Read& read) const
    {
        const Json* value = find(key);
        if (value == nullptr)
            return;
        if (!value->is_array()) {
            wrongType(key, "a list in brackets");
            return;
        }
        for (std::size_t i = 0; i < value->size(); ++i)
            read((*value)[i], pointer(key) + "/" + std::to_string(i));
    }

    /// One of some words; what is given otherwise is a problem and leaves the value as it is.
    /// \param words  pairs of a word and its value.
    template <typename Value, typename Words = std::initializer_list<std::pair<const char*, Value>>>
    void word(std::string_view key, Value& value, const Words& words) const
    {
        if (find(key) == nullptr)
            return;
        const std::string given = text(key);
        std::string known;
        for (const auto& [word, meant] : words) {
            if (given == word) {
                value = meant;
                return;
            }
            known += (known.empty() ? "\"" : " or \"") + std::string(word) + "\"";
        }
        if (find(key)->is_string())
            wrongType(key, known);
    }

    /// The members that are not among the known keys; null when there are none. Each is reported as a
    /// warning, but for those that begin with “_”, which are the user's own notes.
    Json unknown(Keys known) const;
    Json unknown(std::initializer_list<std::string_view> known) const
    {
        return unknown(Keys(known.begin(), known.size()));
    }

private:
    const Json& m_json;
    std::string m_pointer;
    ProjectProblems& m_problems;
};

/// The warning about a key of an object that is not among the known ones: the word that was probably meant,
/// where it is near and not there. Nothing for a note, whose key begins with “_”.
std::optional<ProjectProblem> warningOfUnknown(const Json& json, const std::string& key, std::string pointer,
                                               ObjectReader::Keys known);

} // namespace quadrille
