// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/visitor.h"

#include <cstddef>
#include <string>
#include <variant>

namespace quadrille {

/// Goes through an entry and all that it holds, with the JSON pointer of each. Entry may be const.
/// \tparam Visitor  derived from this one; made anew for each entry, with the same state.
template <template <typename> typename Visitor, typename Entry, typename State>
class EntryWalker : public FieldVisitor<Visitor<Entry>>
{
public:
    EntryWalker(Entry& entry, std::string pointer, State& state)
        : m_entry(entry), m_pointer(std::move(pointer)), m_state(state)
    {
    }

    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char* key, Member member, const FieldInfo& = {}, Unknown = nullptr)
    {
        auto& value = memberOf(m_entry, member);
        if constexpr (!IsOptional<std::remove_cvref_t<decltype(value)>>::value)
            walk(value, place(key));
        else if (value)
            walk(*value, place(key));
    }
    template <typename Fields>
    void group(const char* key, const char*, const char*, auto, const Fields& fields)
    {
        Visitor<Entry> own(m_entry, place(key), m_state);
        fields(own);
    }
    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& = {})
    {
        auto& items = memberOf(m_entry, member);
        for (std::size_t i = 0; i < items.size(); ++i)
            walk(items[i], place(key) + "/" + std::to_string(i));
    }
    template <typename Member>
    void perCharacter(const char* key, Member member, const FieldInfo& info)
    {
        auto& items = memberOf(m_entry, member);
        if (items.size() == 1 && items.front().character.empty())
            walk(items.front(), place(key));
        else
            self().list(key, member, info);
    }
    template <typename Member>
    void variants(const char* key, Member member)
    {
        auto& items = memberOf(m_entry, member);
        for (std::size_t i = 0; i < items.size(); ++i)
            std::visit([&](auto& item) { walk(item, place(key) + "/" + std::to_string(i)); }, items[i]);
    }

protected:
    using FieldVisitor<Visitor<Entry>>::self;
    Entry& entry() { return m_entry; }
    State& state() { return m_state; }
    const std::string& pointer() const { return m_pointer; }
    std::string place(const std::string& key) const { return m_pointer + "/" + key; }

    template <typename Child>
    void walk(Child& child, std::string pointer)
    {
        Visitor<Child> visitor(child, std::move(pointer), m_state);
        describe(visitor, Type<std::remove_const_t<Child>>());
    }

private:
    Entry& m_entry;
    std::string m_pointer;
    State& m_state;
};

} // namespace quadrille
