// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/entryname.h"

#include <algorithm>

namespace quadrille {

std::optional<std::string> problemWithName(const std::string& name)
{
    if (name.empty())
        return "The name is empty";
    if (name == "." || name == "..")
        return "“" + name + "” cannot be a name";
    const bool unusable = std::any_of(name.begin(), name.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return c == '/' || c == '\\' || byte < 0x20 || byte == 0x7F;
    });
    if (unusable)
        return "A name has no slashes and no control characters";
    if (name.size() > longestName)
        return "The name is too long: it has " + std::to_string(name.size()) +
               " bytes, and files of results and exports can be named by " + std::to_string(longestName);
    return std::nullopt;
}

} // namespace quadrille
