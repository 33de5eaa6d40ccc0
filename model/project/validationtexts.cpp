// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/validationtexts.h"

#include "model/project/projectkeys.h"

namespace quadrille {

std::string quoted(const std::string& text)
{
    return "“" + text + "”";
}

std::string meantOr(const std::string& name, const std::vector<std::string>& known, std::string remedy)
{
    const std::vector<std::string_view> views(known.begin(), known.end());
    const auto meant = projectkeys::closestWord(name, views);
    return meant ? "Did you mean " + quoted(*meant) + "?" : std::move(remedy);
}

} // namespace quadrille
