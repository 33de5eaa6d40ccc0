// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/unknownkeys.h"

namespace quadrille {

void addUnknown(UnknownKeys& json, const UnknownKeys& unknown)
{
    if (!unknown.is_object())
        return;
    for (const auto& [key, value] : unknown.items()) {
        if (!json.contains(key))
            json[key] = value;
    }
}

} // namespace quadrille
