// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/codecs.h"

#include <algorithm>
#include <cmath>

namespace quadrille {

namespace {

constexpr std::size_t keysOfChange = 3;
constexpr double greatestTick = 1e6;
constexpr double greatestSpace = 1000;
constexpr double greatestParameter = 1e9;

bool isWholeTo(const Json& number, double greatest)
{
    return number.is_number_integer() && number.get<double>() >= 0 && number.get<double>() <= greatest;
}

bool isChange(const Json& item)
{
    return item.is_array() && item.size() >= keysOfChange &&
           item.size() <= keysOfChange + SpacePoint().size() && isWholeTo(item[0], greatestTick) &&
           isWholeTo(item[1], greatestSpace) && isWholeTo(item[2], 1) &&
           std::all_of(item.begin() + keysOfChange, item.end(), [](const Json& number) {
               return number.is_number() && std::abs(number.get<double>()) <= greatestParameter;
           });
}

} // namespace

void readValue(const ObjectReader& reader, const std::string& key, std::vector<LiveChange>& changes,
               const FieldContext&)
{
    reader.each(key, [&](const Json& item, const std::string& pointer) {
        if (!isChange(item)) {
            reader.invalid(pointer, "An input must be a tick, a space, 0 or 1, and up to three parameters",
                           "Write [tick, space, 1 where latency counts more, parameters…].");
            return;
        }
        LiveChange& change = changes.emplace_back();
        change.tick = item[0].get<std::int64_t>();
        change.input.space = item[1].get<std::size_t>();
        change.input.isResponsive = item[2].get<int>() == 1;
        for (std::size_t p = keysOfChange; p < item.size(); ++p)
            change.input.parameters.at(p - keysOfChange) = item[p].get<double>();
    });
}

void writeValue(Json& json, const std::string& key, const std::vector<LiveChange>& changes,
                const FieldContext&)
{
    if (changes.empty())
        return;
    Json& list = json[key] = Json::array();
    for (const LiveChange& change : changes) {
        Json& item = list.emplace_back(
            Json::array({change.tick, change.input.space, change.input.isResponsive ? 1 : 0}));
        std::size_t count = change.input.parameters.size();
        while (count > 0 && change.input.parameters.at(count - 1) == 0)
            --count;
        for (std::size_t p = 0; p < count; ++p)
            item.push_back(change.input.parameters.at(p));
    }
}

void valueSchema(Json& properties, const std::string& key, Type<std::vector<LiveChange>>)
{
    properties[key] = {
        {"description",
         "What is wanted from a tick on: [tick, which of the spaces, counted from 0, 1 where latency counts "
         "more than likeness or 0, parameters of the space…]. Ticks ascend from 0; parameters that are left "
         "out are 0."},
        {"type", "array"},
        {"items",
         {{"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", keysOfChange},
          {"maxItems", keysOfChange + SpacePoint().size()}}}};
}

} // namespace quadrille
