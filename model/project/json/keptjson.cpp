// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/keptjson.h"

#include "model/project/json/jsontext.h"

namespace quadrille {

std::string textOf(const UnknownKeys& kept)
{
    return writeJson(kept.json());
}

UnknownKeys keptFromText(std::string_view text)
{
    return UnknownKeys(parseJson(text).document);
}

} // namespace quadrille
