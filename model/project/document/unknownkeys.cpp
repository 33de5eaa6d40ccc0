// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/unknownkeys.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace quadrille {

UnknownKeys::UnknownKeys(nlohmann::ordered_json json)
    : m_json(json.is_null() ? nullptr : std::make_shared<const nlohmann::ordered_json>(std::move(json)))
{
}

bool UnknownKeys::contains(const std::string& key) const
{
    return json().contains(key);
}

void UnknownKeys::set(const std::string& key, nlohmann::ordered_json value)
{
    nlohmann::ordered_json changed = json();
    changed[key] = std::move(value);
    *this = UnknownKeys(std::move(changed));
}

void UnknownKeys::erase(const std::string& key)
{
    if (!contains(key))
        return;
    nlohmann::ordered_json changed = json();
    changed.erase(key);
    *this = UnknownKeys(std::move(changed));
}

const nlohmann::ordered_json& UnknownKeys::json() const
{
    static const nlohmann::ordered_json none;
    return m_json == nullptr ? none : *m_json;
}

bool UnknownKeys::operator==(const UnknownKeys& other) const
{
    return m_json == other.m_json || json() == other.json();
}

void addUnknown(nlohmann::ordered_json& json, const nlohmann::ordered_json& unknown)
{
    if (!unknown.is_object())
        return;
    for (const auto& [key, value] : unknown.items()) {
        if (!json.contains(key))
            json[key] = value;
    }
}

void addUnknown(nlohmann::ordered_json& json, const UnknownKeys& unknown)
{
    addUnknown(json, unknown.json());
}

} // namespace quadrille
