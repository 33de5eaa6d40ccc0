// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <filesystem>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// The XML of a COLLADA file, with errors that name the line.
class ColladaDocument
{
public:
    /// \throws Error FileEncoding, FileSyntax.
    ColladaDocument(std::string_view text, const std::filesystem::path& file);

    pugi::xml_node root() const { return m_xml.document_element(); }
    /// The element that "#id" names, which must have the given name.
    /// \throws Error FileSyntax.
    pugi::xml_node find(pugi::xml_node from, const char* url, std::string_view name) const;
    /// The same; null where there is none.
    pugi::xml_node lookUp(const char* url) const;
    /// All elements of a name, in file order.
    std::vector<pugi::xml_node> all(std::string_view name) const;

    /// The numbers that are an element's text.
    /// \throws Error FileSyntax where it holds anything else.
    std::vector<double> numbers(pugi::xml_node element) const;
    /// \overload for whole numbers.
    std::vector<std::int64_t> integers(pugi::xml_node element) const;
    /// An attribute that is a whole number from zero.
    /// \throws Error FileSyntax.
    std::int64_t count(pugi::xml_node element, const char* attribute, std::int64_t fallback) const;

    [[noreturn]] void fail(pugi::xml_node at, const std::string& reason) const;
    ErrorContext contextOf(pugi::xml_node at, std::vector<std::pair<std::string, std::string>> values) const;

private:
    template <typename Number>
    std::vector<Number> parse(pugi::xml_node element, const char* what) const;
    void indexElements();

    std::string_view m_text;
    const std::filesystem::path& m_file;
    pugi::xml_document m_xml;
    std::map<std::string_view, pugi::xml_node> m_byId;
    std::map<std::string_view, std::vector<pugi::xml_node>> m_byName;
};

} // namespace quadrille
