// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/scene/colladadocument.h"

#include "model/core/message.h"
#include "model/sequence/io/files/textscan.h"

#include <algorithm>
#include <charconv>

namespace quadrille {

namespace {

/// Importers walk the elements recursively; real files have a level for each bone of a chain.
constexpr int deepestNesting = 1000;

bool isSpace(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

} // namespace

ColladaDocument::ColladaDocument(std::string_view text, const std::filesystem::path& file)
    : m_text(checkedText(text, file)), m_file(file)
{
    const auto result =
        m_xml.load_buffer(m_text.data(), m_text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result) {
        const auto at =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, result.offset)), m_text.size());
        throwSyntax(file, m_text, m_text.data() + at,
                    std::string("the XML is wrong: ") + result.description());
    }
    if (std::string_view(root().name()) != "COLLADA")
        fail(root(), "the outermost element is not COLLADA");
    indexElements();
}

void ColladaDocument::indexElements()
{
    int depth = 0;
    for (pugi::xml_node at = root(); at;) {
        m_byName[at.name()].push_back(at);
        if (const std::string_view id = at.attribute("id").value(); !id.empty())
            m_byId.try_emplace(id, at);
        if (at.first_child()) {
            at = at.first_child();
            if (++depth > deepestNesting)
                fail(at, QUADRILLE_MESSAGE("elements are nested too deeply"));
            continue;
        }
        while (at && !at.next_sibling() && at != root()) {
            at = at.parent();
            --depth;
        }
        at = at == root() ? pugi::xml_node() : at.next_sibling();
    }
}

pugi::xml_node ColladaDocument::lookUp(const char* url) const
{
    const auto found = m_byId.find(*url == '#' ? url + 1 : url);
    return found == m_byId.end() ? pugi::xml_node() : found->second;
}

pugi::xml_node ColladaDocument::find(pugi::xml_node from, const char* url, std::string_view name) const
{
    const auto found = lookUp(url);
    if (found.name() != name)
        fail(from, "there is no <" + std::string(name) + "> “" + url + "”");
    return found;
}

std::vector<pugi::xml_node> ColladaDocument::all(std::string_view name) const
{
    const auto found = m_byName.find(name);
    return found == m_byName.end() ? std::vector<pugi::xml_node>() : found->second;
}

template <typename Number>
std::vector<Number> ColladaDocument::parse(pugi::xml_node element, const char* what) const
{
    const std::string_view text = element.child_value();
    std::vector<Number> values;
    values.reserve(text.size() / 4);
    const char* const end = text.data() + text.size();
    for (const char* at = text.data();;) {
        while (at != end && isSpace(*at))
            ++at;
        if (at == end)
            return values;
        Number value{};
        const char* const next = scanNumber(at, end, value);
        if (!next || (next != end && !isSpace(*next))) {
            const auto word =
                std::string_view(at, static_cast<std::size_t>(std::find_if(at, end, isSpace) - at));
            fail(element, "<" + std::string(element.name()) + "> holds “" + std::string(word.substr(0, 40)) +
                              "”, which is no " + what);
        }
        values.push_back(value);
        at = next;
    }
}

std::vector<double> ColladaDocument::numbers(pugi::xml_node element) const
{
    return parse<double>(element, "number");
}

std::vector<std::int64_t> ColladaDocument::integers(pugi::xml_node element) const
{
    return parse<std::int64_t>(element, "whole number");
}

std::int64_t ColladaDocument::count(pugi::xml_node element, const char* attribute,
                                    std::int64_t fallback) const
{
    const std::string_view text = element.attribute(attribute).value();
    if (text.empty() && !element.attribute(attribute))
        return fallback;
    std::int64_t value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || value < 0)
        fail(element, "the " + std::string(attribute) + " of <" + element.name() +
                          "> is not a whole number from zero");
    return value;
}

void ColladaDocument::fail(pugi::xml_node at, const std::string& reason) const
{
    throw Error(ErrorCode::FileSyntax, contextOf(at, {{"reason", reason}}));
}

ErrorContext ColladaDocument::contextOf(pugi::xml_node at,
                                        std::vector<std::pair<std::string, std::string>> values) const
{
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, at.offset_debug()));
    const char* const place = m_text.data() + std::min(offset, m_text.size());
    return {m_file, {.line = lineOf(m_text, place)}, std::move(values)};
}

} // namespace quadrille
