// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/jsontext.h"
#include "model/project/project.h"

namespace quadrille {

/// Adds members that an object does not have yet.
void addUnknown(Json& json, const UnknownKeys& unknown);
/// Adds a text unless it is empty.
void addText(Json& json, const char* key, const std::string& text);
/// [first, last]
Json rangeToJson(FrameRange range);
void addRange(Json& json, const char* key, const std::optional<FrameRange>& range);

} // namespace quadrille
