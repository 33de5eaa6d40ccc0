// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/entrypaths.h"

#include "model/project/document/paths.h"
#include "model/project/fields/walker.h"

namespace quadrille {

namespace {

struct PathState
{
    const std::function<void(const StoredPath&)>& visit;
    std::string owner;
};

template <typename Entry>
class PathVisitor : public EntryWalker<PathVisitor, Entry, PathState>
{
    using Base = EntryWalker<PathVisitor, Entry, PathState>;

public:
    using Base::Base;

    template <typename Member>
    void field(const char* key, Member member, const FieldInfo& info = {})
    {
        auto& value = memberOf(this->entry(), member);
        if constexpr (std::is_same_v<decltype(value), std::string&>) {
            const bool isFile =
                info.role == Role::File || (info.role == Role::Source && !clipOfSource(value));
            if (info.role == Role::Name)
                noteOwner(value);
            else if (isFile || info.role == Role::Output)
                visit(key, value, info.role == Role::Output);
        } else if constexpr (std::is_same_v<decltype(value), TextureReference&>) {
            for (std::string& path : value.paths)
                visit(key, path, false);
        }
    }

private:
    void noteOwner(const std::string& name)
    {
        // "/sequences/3", not a part of an entry.
        const std::string& pointer = this->pointer();
        const auto end = pointer.find('/', 1);
        if (pointer.find('/', end + 1) == std::string::npos)
            this->state().owner = pointer.substr(1, end) + name;
    }

    void visit(const char* key, std::string& path, bool isOutput)
    {
        this->state().visit({path, this->state().owner, this->place(key), isOutput});
    }
};

} // namespace

void forEachPath(Project& project, const std::function<void(const StoredPath&)>& visit)
{
    PathState state{visit, {}};
    PathVisitor<Project> visitor(project, "", state);
    describe(visitor, Type<Project>());
}

} // namespace quadrille
