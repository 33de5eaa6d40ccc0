// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/fields/describeproject.h"

#include <cstddef>

namespace quadrille {

/// What a visitor of fields does where it says nothing else: nothing. `Derived` hides what it does itself.
template <typename Derived>
class FieldVisitor
{
public:
    void about(const char*, const char* = "") {}
    /// A member that is the same in every file.
    void constant(const char*, const Json&) {}
    /// Of an entry that is one of several kinds, told apart by the member “kind”.
    void kind(const char* name, const char* help) { self().about(name, help); }

    /// A value: a text, a number, a list of them, or what has a form of its own, see codecs.h.
    template <typename Member>
    void field(const char*, Member, const FieldInfo& = {})
    {
    }
    /// One of some words. \param words  pairs of a word and its value.
    template <typename Member, typename Words>
    void word(const char*, Member, const Words&, const FieldInfo& = {})
    {
    }
    /// The members “label”, “sequence” and “range” of a FrameChoice.
    template <typename Member>
    void choice(Member, const FieldInfo& = {})
    {
    }
    /// Frames with a name, for labels and contacts.
    template <typename Member, typename Name, typename Unknown>
    void spans(const char*, Member, const char*, Name, Unknown, const char*)
    {
    }
    template <typename Member>
    void unknown(Member)
    {
    }

    /// An object of the file. \param unknown  where its unknown keys go, if it does not keep them itself.
    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char*, Member, const FieldInfo& = {}, Unknown = nullptr)
    {
    }
    /// An object that may stand as true or false.
    template <typename Member, typename Unknown = std::nullptr_t>
    void step(const char* key, Member member, const FieldInfo& info = {}, Unknown unknown = nullptr)
    {
        self().object(key, member, info, unknown);
    }
    /// An object of the file whose members are those of the entry around it. \param name, help  see about().
    template <typename Unknown, typename Fields>
    void group(const char*, const char*, const char*, Unknown, const Fields&)
    {
    }
    template <typename Member>
    void list(const char*, Member, const FieldInfo& = {})
    {
    }
    /// A list that may stand as its only item, which then names no character.
    template <typename Member>
    void perCharacter(const char* key, Member member, const FieldInfo& info)
    {
        self().list(key, member, info);
    }
    /// A list of entries of several kinds.
    template <typename Member>
    void variants(const char*, Member)
    {
    }

    template <typename Member>
    void name(const char* key, Member member)
    {
        self().field(key, member, {.need = Need::Required, .role = Role::Name});
    }
    template <typename Member>
    void reference(const char* key, Member member, NamedKind kind, FieldInfo info = {})
    {
        info.role = Role::Reference;
        info.kind = kind;
        self().field(key, member, info);
    }
    /// A text or a number with a role.
    template <typename Member>
    void as(Role role, const char* key, Member member, FieldInfo info = {})
    {
        info.role = role;
        self().field(key, member, info);
    }

protected:
    Derived& self() { return static_cast<Derived&>(*this); }
};

} // namespace quadrille
