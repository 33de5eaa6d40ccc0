// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/members.h"

#include <functional>

namespace quadrille {

/// How a value is read from an entry and written to it.
template <typename Entry, typename Value>
struct Lens
{
    std::function<Value(const Entry&)> get;
    std::function<void(Entry&, Value)> set;
};

/// \param member  a pointer to a member or at().
template <typename Entry, typename Member>
auto lensOf(Member member)
{
    using Value = std::remove_cvref_t<decltype(memberOf(std::declval<Entry&>(), member))>;
    return Lens<Entry, Value>{[member](const Entry& entry) { return memberOf(entry, member); },
                              [member](Entry& entry, Value value) { memberOf(entry, member) = value; }};
}
template <typename Entry, typename Value>
Lens<Entry, Value> lensOf(Lens<Entry, Value> lens)
{
    return lens;
}
/// A member of what an entry may have: as usual where it has not, and then not written. \param outer  a
/// member that is optional.
template <typename Entry, typename Outer, typename Member>
auto lensInside(Outer outer, Member member)
{
    using Owner = PlainMember<Entry, Outer>;
    using Value = std::remove_cvref_t<decltype(memberOf(std::declval<Owner&>(), member))>;
    return Lens<Entry, Value>{[=](const Entry& entry) {
                                  const auto& owner = memberOf(entry, outer);
                                  const Owner usual{};
                                  return memberOf(owner ? *owner : usual, member);
                              },
                              [=](Entry& entry, Value value) {
                                  if (auto& owner = memberOf(entry, outer))
                                      memberOf(*owner, member) = value;
                              }};
}

} // namespace quadrille
