// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/entrymemory.h"

#include "model/project/fields/walker.h"
#include "model/project/json/jsontext.h"

namespace quadrille {

namespace {

template <typename Entry>
class MemoryCounter : public EntryWalker<MemoryCounter, Entry, std::size_t>
{
    using Base = EntryWalker<MemoryCounter, Entry, std::size_t>;

public:
    using Base::Base;

    template <typename Member>
    void field(const char*, Member member, const FieldInfo& = {})
    {
        const auto& value = memberOf(this->entry(), member);
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, std::string>)
            this->state() += value.capacity();
        else if constexpr (std::is_same_v<Value, TextureReference>)
            add(value.paths);
        else if constexpr (std::is_same_v<Value, PathEntry>)
            add(value.points);
        else if constexpr (std::is_same_v<Value, ObstacleEntry>)
            add(value.corners);
        else if constexpr (requires { value.size(), value[0]; })
            add(value);
    }
    template <typename Member, typename Name, typename Unknown>
    void spans(const char*, Member member, const char*, Name name, Unknown, const char*)
    {
        add(memberOf(this->entry(), member));
        for (const auto& span : memberOf(this->entry(), member))
            this->state() += (span.*name).capacity();
    }
    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& info = {})
    {
        add(memberOf(this->entry(), member));
        Base::list(key, member, info);
    }
    template <typename Member>
    void variants(const char* key, Member member)
    {
        add(memberOf(this->entry(), member));
        Base::variants(key, member);
    }
    template <typename Member>
    void unknown(Member member)
    {
        const UnknownKeys& keys = memberOf(this->entry(), member);
        this->state() += keys.isNone() ? 0 : keys.json().dump().size() * 2;
    }

private:
    template <typename Items>
    void add(const Items& items)
    {
        this->state() += items.size() * sizeof(items[0]);
        if constexpr (std::is_same_v<Items, std::vector<std::string>>) {
            for (const std::string& text : items)
                this->state() += text.capacity();
        }
    }
};

} // namespace

template <typename Entry>
std::size_t memoryOf(const Entry& entry)
{
    std::size_t bytes = sizeof(entry);
    MemoryCounter<const Entry> counter(entry, "", bytes);
    describe(counter, Type<Entry>());
    return bytes;
}

template std::size_t memoryOf(const ProjectSettings&);
template std::size_t memoryOf(const CharacterEntry&);
template std::size_t memoryOf(const SequenceEntry&);
template std::size_t memoryOf(const BodyPartsEntry&);
template std::size_t memoryOf(const GraphEntry&);
template std::size_t memoryOf(const AnimationEntry&);
template std::size_t memoryOf(const VariationEntry&);
template std::size_t memoryOf(const MotionSpaceEntry&);
template std::size_t memoryOf(const LiveEntry&);
template std::size_t memoryOf(const AppearanceEntry&);
template std::size_t memoryOf(const TransferEntry&);
template std::size_t memoryOf(const ProjectionEntry&);
template std::size_t memoryOf(const EvaluationEntry&);
template std::size_t memoryOf(const ExportEntry&);
template std::size_t memoryOf(const Project&);

} // namespace quadrille
