// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string>
#include <unordered_map>
#include <vector>

namespace quadrille {

/// Texts in a row, of which each different one is kept once: columns of large tables have few words.
class TextColumn
{
public:
    using value_type = std::string;

    class Iterator
    {
    public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = std::string;
        using difference_type = std::ptrdiff_t;
        using pointer = const std::string*;
        using reference = const std::string&;

        Iterator() = default;
        reference operator*() const { return (*m_column)[m_at]; }
        pointer operator->() const { return &(*m_column)[m_at]; }
        Iterator& operator++()
        {
            ++m_at;
            return *this;
        }
        Iterator operator++(int)
        {
            Iterator before = *this;
            ++m_at;
            return before;
        }
        difference_type operator-(const Iterator& other) const
        {
            return static_cast<difference_type>(m_at) - static_cast<difference_type>(other.m_at);
        }
        bool operator==(const Iterator&) const = default;

    private:
        friend class TextColumn;
        Iterator(const TextColumn* column, std::size_t at) : m_column(column), m_at(at) {}
        const TextColumn* m_column = nullptr;
        std::size_t m_at = 0;
    };
    using const_iterator = Iterator;
    using iterator = Iterator;

    TextColumn() = default;
    /// Cost: O(texts) look-ups of a hash.
    TextColumn(const std::vector<std::string>& texts);
    TextColumn(std::initializer_list<std::string> texts) : TextColumn(std::vector<std::string>(texts)) {}

    std::size_t size() const { return m_places.size(); }
    bool empty() const { return m_places.empty(); }
    /// \pre at < size().
    const std::string& operator[](std::size_t at) const { return m_words[m_places[at]]; }
    /// \throws std::out_of_range.
    const std::string& at(std::size_t at) const { return m_words[m_places.at(at)]; }
    const std::string& front() const { return (*this)[0]; }
    const std::string& back() const { return (*this)[size() - 1]; }
    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, size()}; }
    /// Each different text, in the order in which they come.
    const std::vector<std::string>& words() const { return m_words; }
    /// All texts, each a copy.
    std::vector<std::string> list() const;
    /// What it takes in memory.
    std::uint64_t bytes() const;

    void reserve(std::size_t size) { m_places.reserve(size); }
    void push_back(const std::string& text);

    bool operator==(const TextColumn& other) const
    {
        return m_words == other.m_words && m_places == other.m_places;
    }

private:
    std::vector<std::string> m_words;
    std::unordered_map<std::string, std::uint32_t> m_placeOf; ///< of each word
    std::vector<std::uint32_t> m_places;                      ///< of the word of each text
};

} // namespace quadrille
