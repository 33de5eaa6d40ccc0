// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille {

/// A member of a member, as &Outer::inner is one of a struct.
template <typename First, typename... Rest>
constexpr auto at(First first, Rest... rest)
{
    return [=](auto& entry) -> auto&
    {
        if constexpr (sizeof...(rest) == 0)
            return entry.*first;
        else
            return at(rest...)(entry.*first);
    };
}

/// The value of a pointer to a member or of at().
template <typename Entry, typename Member>
auto& memberOf(Entry& entry, const Member& member)
{
    if constexpr (std::is_member_pointer_v<Member>)
        return entry.*member;
    else
        return member(entry);
}

/// The number in a frame, a vertex or a time; any other value as it is.
template <typename Value>
auto bare(const Value& value)
{
    if constexpr (requires { value.value; })
        return value.value;
    else
        return value;
}

template <typename Value>
struct IsOptional : std::false_type
{
};
template <typename Value>
struct IsOptional<std::optional<Value>> : std::true_type
{
};

/// What a member is without std::optional.
template <typename Value>
struct Plain
{
    using Type = Value;
};
template <typename Value>
struct Plain<std::optional<Value>>
{
    using Type = Value;
};

/// Whether values are single numbers, and whether they are whole.
template <typename Value>
inline constexpr bool isNumber =
    std::is_arithmetic_v<decltype(bare(std::declval<Value>()))> && !std::is_same_v<Value, bool>;
template <typename Value>
inline constexpr bool isWhole = std::is_integral_v<decltype(bare(std::declval<Value>()))>;

template <typename Value>
inline constexpr bool isListOfWholes = false;
template <typename Item>
inline constexpr bool isListOfWholes<std::vector<Item>> = isNumber<Item>&& isWhole<Item>;

/// The type of a member of an entry, without std::optional.
template <typename Entry, typename Member>
using PlainMember = typename Plain<
    std::remove_cvref_t<decltype(memberOf(std::declval<Entry&>(), std::declval<Member>()))>>::Type;

} // namespace quadrille
