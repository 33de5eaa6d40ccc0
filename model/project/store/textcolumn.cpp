// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/store/textcolumn.h"

namespace quadrille {

TextColumn::TextColumn(const std::vector<std::string>& texts)
{
    reserve(texts.size());
    for (const std::string& text : texts)
        push_back(text);
}

std::vector<std::string> TextColumn::list() const
{
    std::vector<std::string> texts;
    texts.reserve(size());
    for (const std::uint32_t place : m_places)
        texts.push_back(m_words[place]);
    return texts;
}

std::uint64_t TextColumn::bytes() const
{
    std::uint64_t bytes = m_places.size() * sizeof(std::uint32_t);
    for (const std::string& word : m_words)
        bytes += 2 * (sizeof(std::string) + word.size());
    return bytes;
}

void TextColumn::push_back(const std::string& text)
{
    if (!m_places.empty() && m_words[m_places.back()] == text) {
        m_places.push_back(m_places.back());
        return;
    }
    const auto [found, isNew] = m_placeOf.try_emplace(text, static_cast<std::uint32_t>(m_words.size()));
    if (isNew)
        m_words.push_back(text);
    m_places.push_back(found->second);
}

} // namespace quadrille
