// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/project.h"
#include "model/project/json/jsontext.h"

#include <optional>
#include <string>
#include <type_traits>

namespace quadrille {

/// Adds a text unless it is empty.
void addText(Json& json, const std::string& key, const std::string& text);
/// Adds a member unless it is as usual.
template <typename Value>
void addUnless(Json& json, const std::string& key, const Value& value,
               const std::type_identity_t<Value>& usual)
{
    if (value != usual)
        json[key] = value;
}
/// Adds a member where there is one.
template <typename Value>
void addOptional(Json& json, const std::string& key, const std::optional<Value>& value)
{
    if (value)
        json[key] = *value;
}

/// [first, last]
Json rangeToJson(FrameRange range);
void addRange(Json& json, const std::string& key, const std::optional<FrameRange>& range);

} // namespace quadrille
