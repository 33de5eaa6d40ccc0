// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/json/jsonmembers.h"

namespace quadrille {

void addText(Json& json, const std::string& key, const std::string& text)
{
    if (!text.empty())
        json[key] = text;
}

Json rangeToJson(FrameRange range)
{
    return Json::array({range.first.value, range.last.value});
}

void addRange(Json& json, const std::string& key, const std::optional<FrameRange>& range)
{
    if (range)
        json[key] = rangeToJson(*range);
}

} // namespace quadrille
