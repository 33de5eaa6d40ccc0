// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/jsontext.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

namespace quadrille {

namespace {

bool startsCharacter(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// Turns growing byte offsets into lines and columns.
class PlaceCounter
{
public:
    explicit PlaceCounter(std::string_view text) : m_text(text) {}

    ErrorPlace at(std::size_t offset)
    {
        for (; m_offset < std::min(offset, m_text.size()); ++m_offset) {
            if (m_text[m_offset] == '\n') {
                ++m_line;
                m_column = 1;
            } else if (startsCharacter(m_text[m_offset])) {
                ++m_column;
            }
        }
        return {.line = m_line, .column = m_column};
    }

private:
    std::string_view m_text;
    std::size_t m_offset = 0;
    std::int64_t m_line = 1;
    std::int64_t m_column = 1;
};

Error syntaxError(const std::filesystem::path& file, ErrorPlace place, std::string reason)
{
    return Error(ErrorCode::ProjectSyntax, {file, place, {{"reason", std::move(reason)}}});
}

/// Walks over JSON text that is known to be valid and notes where each value stands.
class Locator
{
public:
    Locator(std::string_view text, const std::filesystem::path& file, JsonText& out)
        : m_text(text), m_file(file), m_places(text), m_out(out)
    {
    }

    void run()
    {
        if (m_text.starts_with("\xEF\xBB\xBF"))
            m_at = 3;
        skipSpace();
        value("", m_places.at(m_at));
    }

private:
    void value(const std::string& pointer, const ErrorPlace& key)
    {
        const ErrorPlace place = m_places.at(m_at);
        m_out.locations[pointer] = {key, place};
        switch (m_text[m_at]) {
        case '{':
            object(pointer);
            break;
        case '[':
            array(pointer);
            break;
        case '"':
            string();
            break;
        default:
            m_at = std::min(m_text.find_first_of(",]} \t\r\n", m_at), m_text.size());
        }
    }

    void object(const std::string& pointer)
    {
        ++m_at;
        std::set<std::string> seen;
        for (skipSpace(); m_text[m_at] != '}'; skipSpace()) {
            if (m_text[m_at] == ',') {
                ++m_at;
                continue;
            }
            const ErrorPlace place = m_places.at(m_at);
            const std::string key = Json::parse(string());
            if (!seen.insert(key).second)
                throw syntaxError(m_file, place, "the key “" + key + "” appears twice");
            skipSpace();
            ++m_at; // the colon
            skipSpace();
            value(pointer + "/" + escapePointer(key), place);
        }
        ++m_at;
    }

    void array(const std::string& pointer)
    {
        ++m_at;
        std::size_t index = 0;
        for (skipSpace(); m_text[m_at] != ']'; skipSpace()) {
            if (m_text[m_at] == ',') {
                ++m_at;
                continue;
            }
            value(pointer + "/" + std::to_string(index++), m_places.at(m_at));
        }
        ++m_at;
    }

    std::string_view string()
    {
        const std::size_t begin = m_at++;
        while (m_text[m_at] != '"')
            m_at += m_text[m_at] == '\\' ? 2 : 1;
        ++m_at;
        return m_text.substr(begin, m_at - begin);
    }

    void skipSpace() { m_at = std::min(m_text.find_first_not_of(" \t\r\n", m_at), m_text.size()); }

    std::string_view m_text;
    const std::filesystem::path& m_file;
    PlaceCounter m_places;
    JsonText& m_out;
    std::size_t m_at = 0;
};

/// The parser's own words without its prefixes, in one line.
std::string plainReason(std::string_view what)
{
    if (const auto at = what.find(" - "); at != std::string_view::npos)
        what.remove_prefix(at + 3);
    constexpr std::size_t longest = 200;
    return std::string(what.substr(0, longest));
}

bool holdsOnlyNumbers(const Json& array)
{
    return std::all_of(array.begin(), array.end(), [](const Json& item) { return item.is_number(); });
}

void writeValue(const Json& value, int indent, std::string& out);

void writeScalar(const Json& value, std::string& out)
{
    if (value.is_number_float()) {
        const auto number = value.get<double>();
        if (number == std::floor(number) && std::abs(number) < 1e15) {
            out += std::to_string(static_cast<std::int64_t>(number));
            return;
        }
    }
    out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void writeChildren(const Json& value, int indent, std::string& out)
{
    const bool isObject = value.is_object();
    out += isObject ? "{\n" : "[\n";
    bool first = true;
    for (auto item = value.begin(); item != value.end(); ++item) {
        out += first ? "" : ",\n";
        first = false;
        out.append(static_cast<std::size_t>(indent) + 2, ' ');
        if (isObject) {
            writeScalar(Json(item.key()), out);
            out += ": ";
        }
        writeValue(*item, indent + 2, out);
    }
    out += '\n';
    out.append(static_cast<std::size_t>(indent), ' ');
    out += isObject ? '}' : ']';
}

void writeValue(const Json& value, int indent, std::string& out)
{
    if (!value.is_structured()) {
        writeScalar(value, out);
    } else if (value.empty()) {
        out += value.is_object() ? "{}" : "[]";
    } else if (value.is_array() && holdsOnlyNumbers(value)) {
        const char* separator = "[";
        for (const Json& item : value) {
            out += separator;
            writeScalar(item, out);
            separator = ", ";
        }
        out += ']';
    } else {
        writeChildren(value, indent, out);
    }
}

} // namespace

ErrorPlace JsonText::placeOf(std::string_view pointer) const
{
    for (;;) {
        if (const auto found = locations.find(pointer); found != locations.end())
            return found->second.value;
        if (pointer.empty())
            return {};
        pointer = pointer.substr(0, pointer.rfind('/'));
    }
}

ErrorPlace JsonText::placeOfKey(std::string_view pointer) const
{
    const auto found = locations.find(pointer);
    return found == locations.end() ? placeOf(pointer) : found->second.key;
}

JsonText parseJson(std::string_view text, const std::filesystem::path& file)
{
    JsonText parsed;
    const auto checkDepth = [&](int depth, Json::parse_event_t, const Json&) {
        if (depth > maxJsonDepth)
            throw syntaxError(file, {}, "it is nested deeper than " + std::to_string(maxJsonDepth));
        return true;
    };
    try {
        parsed.document = Json::parse(text, checkDepth);
    } catch (const Json::parse_error& error) {
        const std::size_t offset = error.byte > 0 ? error.byte - 1 : 0;
        const ErrorPlace place = PlaceCounter(text).at(offset);
        if (std::string_view(error.what()).find("UTF-8") != std::string_view::npos)
            throw Error(ErrorCode::FileEncoding, {file, place, {}});
        throw syntaxError(file, place, plainReason(error.what()));
    } catch (const Json::out_of_range& error) {
        throw syntaxError(file, {}, "a number is too large");
    }
    Locator(text, file, parsed).run();
    return parsed;
}

std::string writeJson(const Json& document)
{
    std::string out;
    writeValue(document, 0, out);
    return out + "\n";
}

std::string escapePointer(std::string_view text)
{
    std::string escaped;
    for (const char c : text) {
        if (c == '~')
            escaped += "~0";
        else if (c == '/')
            escaped += "~1";
        else
            escaped += c;
    }
    return escaped;
}

} // namespace quadrille
