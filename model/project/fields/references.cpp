// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/references.h"

#include "model/core/contains.h"
#include "model/project/document/paths.h"
#include "model/project/fields/walker.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

namespace quadrille {

namespace {

/// Of which kind the entries of a section are, where others speak of them.
template <typename Entry>
constexpr std::optional<NamedKind> kindOf()
{
    if constexpr (std::is_same_v<Entry, CharacterEntry>)
        return NamedKind::Character;
    else if constexpr (std::is_same_v<Entry, SequenceEntry>)
        return NamedKind::Sequence;
    else if constexpr (std::is_same_v<Entry, AnimationEntry>)
        return NamedKind::Animation;
    else if constexpr (std::is_same_v<Entry, VariationEntry>)
        return NamedKind::Variation;
    else if constexpr (std::is_same_v<Entry, MotionSpaceEntry>)
        return NamedKind::MotionSpace;
    else if constexpr (std::is_same_v<Entry, LiveEntry>)
        return NamedKind::Live;
    else if constexpr (std::is_same_v<Entry, TransferEntry>)
        return NamedKind::Transfer;
    else if constexpr (std::is_same_v<Entry, ProjectionEntry>)
        return NamedKind::Projection;
    else
        return std::nullopt;
}

/// Calls a function with the key of the section of a kind and its entries.
template <typename Function>
class KindFinder : public FieldVisitor<KindFinder<Function>>
{
public:
    KindFinder(Project& project, NamedKind kind, const Function& function)
        : m_project(project), m_kind(kind), m_function(function)
    {
    }

    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& = {})
    {
        auto& entries = memberOf(m_project, member);
        using Entry = typename std::remove_cvref_t<decltype(entries)>::value_type;
        if constexpr (constexpr auto kind = kindOf<Entry>(); kind) {
            if (*kind == m_kind)
                m_function(key, entries);
        }
    }

private:
    Project& m_project;
    NamedKind m_kind;
    const Function& m_function;
};

template <typename Function>
void withEntries(Project& project, NamedKind kind, const Function& function)
{
    KindFinder<Function> finder(project, kind, function);
    describe(finder, Type<Project>());
}

/// The new name of an entry that is spoken of; nothing where it is gone.
using NameChange = std::function<std::optional<std::string>(const std::string& name)>;

/// Names of entries that cannot be without others.
using LostEntries = std::map<NamedKind, std::vector<std::string>>;

struct ReferenceChange
{
    NamedKind kind;
    std::string section; ///< key of the entries of the kind
    const NameChange& rename;
    std::optional<std::string> onlyCharacter;
    LostEntries lost;

    /// Renames in place. \return false where the name is gone.
    bool keeps(std::string& name) const
    {
        if (name.empty())
            return true;
        auto changed = rename(name);
        if (changed)
            name = std::move(*changed);
        return changed.has_value();
    }

    bool keepsClip(std::string& clip) const
    {
        auto name = nameOfClip(clip, section);
        if (!name)
            return true;
        // Clips of variations have a number behind the name.
        const auto slash = std::min(name->find('/'), name->size());
        const std::string number = name->substr(slash);
        if (kind == NamedKind::Variation)
            name->resize(slash);
        if (!keeps(*name))
            return false;
        clip = section + "/" + *name + (kind == NamedKind::Variation ? number : "");
        return true;
    }
};

/// Changes the names in an entry, and finds out whether it can stay.
template <typename Entry>
class ReferenceChanger : public FieldVisitor<ReferenceChanger<Entry>>
{
public:
    ReferenceChanger(Entry& entry, ReferenceChange& change) : m_entry(entry), m_change(change) {}

    bool isLost() const { return m_isLost; }

    template <typename Member>
    void field(const char*, Member member, const FieldInfo& info = {})
    {
        auto& value = memberOf(m_entry, member);
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, std::string>)
            changeText(value, info);
        else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
            changeNames(value, info);
        else if constexpr (std::is_same_v<Value, std::vector<JunctionEntry>>)
            changeJunctions(value);
    }
    template <typename Member>
    void choice(Member member, [[maybe_unused]] const FieldInfo& info = {})
    {
        auto& value = memberOf(m_entry, member);
        FrameChoice* choice = nullptr;
        if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value)
            choice = value ? &*value : nullptr;
        else
            choice = &value;
        if (choice == nullptr || m_change.kind != NamedKind::Sequence || m_change.keeps(choice->sequence))
            return;
        if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value)
            value.reset();
        else
            m_isLost = true;
    }
    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char*, Member member, [[maybe_unused]] const FieldInfo& info = {}, Unknown = nullptr)
    {
        auto& value = memberOf(m_entry, member);
        if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value) {
            if (!value || keepsEntry(*value))
                return;
            if (info.loss == Loss::OfOwner)
                m_isLost = true;
            else
                value.reset();
        } else {
            m_isLost |= !keepsEntry(value);
        }
    }
    template <typename Member>
    void list(const char*, Member member, const FieldInfo& info = {})
    {
        auto& items = memberOf(m_entry, member);
        const std::size_t before = items.size();
        std::erase_if(items, [&](auto& item) {
            const bool isGone = !keepsEntry(item);
            if constexpr (constexpr auto kind = kindOf<std::remove_cvref_t<decltype(item)>>(); kind) {
                if (isGone)
                    m_change.lost[*kind].push_back(item.name);
            }
            return isGone;
        });
        if (info.loss == Loss::OfWhole && items.size() != before)
            items.clear();
        const bool needsItems = info.loss == Loss::OfOwner || info.leastItems > 0;
        m_isLost |= needsItems && before != 0 && items.empty();
    }
    template <typename Member>
    void variants(const char*, Member member)
    {
        std::erase_if(memberOf(m_entry, member), [&](auto& item) {
            return !std::visit([&](auto& entry) { return keepsEntry(entry); }, item);
        });
    }

private:
    void changeText(std::string& text, const FieldInfo& info)
    {
        if (info.role == Role::Clip && info.need == Need::Required) {
            m_isLost |= !m_change.keepsClip(text);
        } else if (info.role == Role::Clip) {
            if (!m_change.keepsClip(text))
                text.clear();
        } else if (auto clip = clipOfSource(text); clip && info.role == Role::Source) {
            m_isLost |= !m_change.keepsClip(*clip);
            text = "clip:" + *clip;
        } else if (info.role == Role::Character && m_change.kind == NamedKind::Character) {
            // No name stands for the only character.
            const bool isMeant = text.empty() && m_change.onlyCharacter;
            m_isLost |= isMeant ? !m_change.rename(*m_change.onlyCharacter) : !m_change.keeps(text);
        } else if (info.role == Role::Reference && m_change.kind == info.kind && !m_change.keeps(text)) {
            if (info.need == Need::Required || info.loss == Loss::OfOwner)
                m_isLost = true;
            else
                text.clear();
        }
    }

    void changeNames(std::vector<std::string>& names, const FieldInfo& info)
    {
        if (info.role != Role::Reference || m_change.kind != info.kind)
            return;
        const bool isAnyLost =
            std::erase_if(names, [&](std::string& name) { return !m_change.keeps(name); }) > 0;
        m_isLost |= isAnyLost && names.empty() && info.loss == Loss::OfOwner;
        if constexpr (requires { m_entry.needsAllSequences(); }) {
            if (isAnyLost && m_entry.needsAllSequences())
                names.clear();
        }
    }

    void changeJunctions(std::vector<JunctionEntry>& junctions)
    {
        if (m_change.kind != NamedKind::Sequence)
            return;
        std::erase_if(junctions, [&](JunctionEntry& junction) {
            const bool keepsFrom = m_change.keeps(junction.from.sequence);
            return !m_change.keeps(junction.to.sequence) || !keepsFrom;
        });
    }

    template <typename Child>
    bool keepsEntry(Child& entry)
    {
        ReferenceChanger<Child> changer(entry, m_change);
        if constexpr (requires { entry.saysNothing(); }) {
            const bool saidNothing = entry.saysNothing();
            describe(changer, Type<Child>());
            return !changer.isLost() && (saidNothing || !entry.saysNothing());
        } else {
            describe(changer, Type<Child>());
            return !changer.isLost();
        }
    }

    Entry& m_entry;
    ReferenceChange& m_change;
    bool m_isLost = false;
};

/// Gives every entry that names no character the name of one.
template <typename Entry>
class CharacterNamer : public EntryWalker<CharacterNamer, Entry, const std::string>
{
public:
    using EntryWalker<CharacterNamer, Entry, const std::string>::EntryWalker;

    template <typename Member>
    void field(const char*, Member member, const FieldInfo& info = {})
    {
        auto& value = memberOf(this->entry(), member);
        if constexpr (std::is_same_v<decltype(value), std::string&>) {
            if (info.role == Role::Character && value.empty())
                value = this->state();
        }
    }
};

/// Changes all references to entries of a kind, and removes what speaks of those that are gone.
/// \return what went; references to that are still there.
LostEntries changeReferences(Project& project, NamedKind kind, const NameChange& rename)
{
    ReferenceChange change{kind, {}, rename, {}, {}};
    withEntries(project, kind, [&](const char* key, const auto&) { change.section = key; });
    if (project.characters.size() == 1)
        change.onlyCharacter = project.characters.front().name;
    ReferenceChanger<Project> changer(project, change);
    describe(changer, Type<Project>());
    return std::move(change.lost);
}

} // namespace

void renameEntry(Project& project, NamedKind kind, const std::string& before, const std::string& after)
{
    changeReferences(project, kind, [&](const std::string& name) { return name == before ? after : name; });
    withEntries(project, kind, [&](const char*, auto& entries) {
        for (auto& entry : entries) {
            if (entry.name == before)
                entry.name = after;
        }
    });
}

void nameOnlyCharacter(Project& project)
{
    const std::string name = project.characters.front().name;
    CharacterNamer<Project> namer(project, "", name);
    describe(namer, Type<Project>());
}

void removeEntries(Project& project, NamedKind kind, const std::vector<std::string>& names)
{
    if (names.empty())
        return;
    const auto isGone = [&](const std::string& name) { return contains(names, name); };
    const LostEntries lost = changeReferences(project, kind, [&](const std::string& name) {
        return isGone(name) ? std::nullopt : std::optional(name);
    });
    withEntries(project, kind, [&](const char*, auto& entries) {
        std::erase_if(entries, [&](const auto& entry) { return isGone(entry.name); });
    });
    for (const auto& [lostKind, lostNames] : lost)
        removeEntries(project, lostKind, lostNames);
}

} // namespace quadrille
