// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <string>
#include <vector>

namespace quadrille {

/// A value, or a list of values, as JSON in one line: for those who write no more than that.
class JsonLine
{
public:
    /// null where it is not finite.
    JsonLine(double value);
    /// A whole number, or true or false.
    template <std::integral Whole>
    JsonLine(Whole value) : m_text(std::to_string(value))
    {
        if constexpr (std::same_as<Whole, bool>)
            m_text = value ? "true" : "false";
    }
    /// \throws nlohmann::json::type_error where it is not UTF-8.
    JsonLine(const std::string& text);
    JsonLine(const char* text) : JsonLine(std::string(text)) {}
    template <typename Item>
    JsonLine(const std::vector<Item>& list) : m_text("[")
    {
        for (const Item& item : list)
            m_text += (m_text.size() == 1 ? "" : ",") + JsonLine(item).m_text;
        m_text += ']';
    }

    const std::string& text() const { return m_text; }

private:
    std::string m_text;
};

/// The text of a list.
inline std::string jsonLine(const std::vector<JsonLine>& list)
{
    return JsonLine(list).text();
}

} // namespace quadrille
