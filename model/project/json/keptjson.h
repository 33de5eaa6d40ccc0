// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/unknownkeys.h"

#include <string>
#include <string_view>

namespace quadrille {

/// What is kept as it stands in the file, as text, see writeJson().
std::string textOf(const UnknownKeys& kept);
/// \throws Error as parseJson().
UnknownKeys keptFromText(std::string_view text);

} // namespace quadrille
