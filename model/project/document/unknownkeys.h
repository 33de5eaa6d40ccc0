// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace quadrille {

/// Keys of the project file that this version does not know, or another part of it that stays as it stands
/// there; kept and written again. A value: copies share what they hold until one of them is changed. That it
/// is JSON is known to those who read and write it only, as the header of that takes long to compile.
class UnknownKeys
{
public:
    UnknownKeys() = default;
    /// \param json  null for none.
    explicit UnknownKeys(nlohmann::ordered_json json);

    bool isNone() const { return m_json == nullptr; }
    /// Whether it is an object with such a member.
    bool contains(const std::string& key) const;
    /// Adds a member, or gives it another value in its place. \pre It is an object, or none.
    void set(const std::string& key, nlohmann::ordered_json value);
    /// Nothing happens where there is no such member.
    void erase(const std::string& key);

    /// null where there is none.
    const nlohmann::ordered_json& json() const;

    bool operator==(const UnknownKeys& other) const;

private:
    std::shared_ptr<const nlohmann::ordered_json> m_json; ///< null: none
};

/// Adds members that an object does not have yet.
void addUnknown(nlohmann::ordered_json& json, const nlohmann::ordered_json& unknown);
void addUnknown(nlohmann::ordered_json& json, const UnknownKeys& unknown);

} // namespace quadrille
