// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace quadrille {

/// Declared only; those who look into one include jsontext.h.
using Json = nlohmann::ordered_json;

} // namespace quadrille
