// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

namespace quadrille {

/// Keys of the project file that this version does not know; kept and written again.
using UnknownKeys = nlohmann::ordered_json;

/// Adds members that an object does not have yet.
void addUnknown(UnknownKeys& json, const UnknownKeys& unknown);

} // namespace quadrille
