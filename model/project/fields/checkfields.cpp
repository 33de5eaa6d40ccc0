// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/checkfields.h"

#include "model/core/contains.h"
#include "model/project/document/entryname.h"
#include "model/project/document/paths.h"
#include "model/project/document/problemtexts.h"
#include "model/project/fields/walker.h"

#include <cmath>
#include <set>

namespace quadrille {

namespace {

struct CheckState
{
    const Project& project;
    ProjectProblems& problems;
};

/// Says what is wrong with a path of the file.
void checkPath(const std::string& path, const std::string& place, ProjectProblems& problems)
{
    constexpr std::size_t longestFileName = 255; // bytes, of Linux's file systems
    for (const auto& part : std::filesystem::path(path)) {
        if (part.native().size() > longestFileName)
            problems.push_back(invalidAt(place,
                                         "The path has a file name of more than " +
                                             std::to_string(longestFileName) +
                                             " bytes, which no disk can hold",
                                         "Choose a shorter name."));
    }
    if (path.find('\\') != std::string::npos)
        problems.push_back(warningAt(place, "The path " + quoted(path) + " has backslashes",
                                     "Write forward slashes, on every system."));
    else if (!path.empty() && std::filesystem::path(path).is_absolute())
        problems.push_back(warningAt(place, "The path " + quoted(path) + " holds for this machine only",
                                     "Write it relative to the project file."));
}

template <typename Entry>
class FieldChecker : public EntryWalker<FieldChecker, Entry, CheckState>
{
    using Base = EntryWalker<FieldChecker, Entry, CheckState>;

public:
    using Base::Base;

    /// In lists of named entries, the names so far.
    void setNames(std::set<std::string>* names) { m_names = names; }

    template <typename Member>
    void field(const char* key, Member member, const FieldInfo& info = {})
    {
        const auto& value = memberOf(this->entry(), member);
        if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value) {
            if (value)
                checkValue(key, *value, info);
        } else {
            checkValue(key, value, info);
        }
    }

    template <typename Member>
    void choice(Member member, const FieldInfo& = {})
    {
        const std::optional<FrameChoice> choice = memberOf(this->entry(), member);
        if (choice && choice->range)
            checkValue("range", *choice->range, {});
    }

    template <typename Member, typename Name, typename Unknown>
    void spans(const char* key, Member member, const char* nameKey, Name name, Unknown, const char*)
    {
        const auto& spans = memberOf(this->entry(), member);
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const std::string place = key + ("/" + std::to_string(i)) + "/";
            if ((spans[i].*name).empty())
                invalid(place + nameKey, quoted(nameKey).append(" is empty here"));
            checkValue(place + "frames", spans[i].frames, {});
        }
    }

    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& = {})
    {
        const auto& items = memberOf(this->entry(), member);
        std::set<std::string> names;
        for (std::size_t i = 0; i < items.size(); ++i) {
            using Item = std::remove_reference_t<decltype(items[i])>;
            FieldChecker<Item> item(items[i], this->place(key) + "/" + std::to_string(i), this->state());
            item.setNames(&names);
            describe(item, Type<std::remove_const_t<Item>>());
        }
    }

private:
    void invalid(const std::string& key, std::string reason, std::string remedy = {})
    {
        this->state().problems.push_back(invalidAt(this->place(key), std::move(reason), std::move(remedy)));
    }

    template <typename Value>
    void checkValue(const std::string& key, const Value& value, const FieldInfo& info)
    {
        if constexpr (isNumber<Value>) {
            checkNumber(key, static_cast<double>(bare(value)), info.limits);
        } else if constexpr (std::is_same_v<Value, std::string>) {
            checkText(key, value, info);
        } else if constexpr (std::is_same_v<Value, FrameRange>) {
            if (value.count() == 0)
                invalid(key, "The range ends before it begins",
                        "Write [first, last], zero-based, both included.");
        } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
            for (const double number : value) {
                if (!checkNumber(key, number, info.limits))
                    return;
            }
        } else if constexpr (std::is_same_v<Value, TextureReference>) {
            for (const std::string& path : value.paths)
                checkPath(path, this->place(key), this->state().problems);
        }
    }

    void checkText(const std::string& key, const std::string& text, const FieldInfo& info)
    {
        switch (info.role) {
        case Role::Name:
            checkName(key, text);
            break;
        case Role::Character:
            checkCharacter(key, text);
            break;
        case Role::Reference: // other names depend on more than themselves
            if (info.kind == NamedKind::Character && !text.empty())
                checkCharacter(key, text);
            else if (info.isAnyOfProject)
                checkSequence(key, text);
            break;
        case Role::Output:
            if (text.empty())
                invalid(key, "The path is empty", "Name the file to write.");
            checkPath(text, this->place(key), this->state().problems);
            break;
        case Role::Source:
            if (text.empty())
                invalid(key, "The source is empty", "Name a file, a series or a clip.");
            if (clipOfSource(text))
                break;
            [[fallthrough]];
        case Role::File:
            checkPath(text, this->place(key), this->state().problems);
            break;
        default:
            break;
        }
    }

    void checkName(const std::string& key, const std::string& name)
    {
        if (const auto reason = problemWithName(name))
            invalid(key, *reason);
        else if (m_names != nullptr && !m_names->insert(name).second)
            invalid(key, "There are two entries with the name " + quoted(name) + " here",
                    "Give one of them another name.");
    }

    void checkSequence(const std::string& key, const std::string& name)
    {
        const auto known = namesOf(this->state().project.sequences);
        if (!contains(known, name))
            invalid(key, "There is no sequence " + quoted(name), meantOr(name, known, "Correct the name."));
    }

    void checkCharacter(const std::string& key, const std::string& name)
    {
        const auto known = namesOf(this->state().project.characters);
        if (name.empty() && known.size() > 1)
            this->state().problems.push_back(invalidAt(this->pointer(), "“character” is missing here",
                                                       "The project has several characters."));
        else if (!name.empty() && !contains(known, name))
            invalid(key, "There is no character " + quoted(name),
                    meantOr(name, known, "Add it under “characters”."));
    }

    /// \return whether it is within its limits.
    bool checkNumber(const std::string& key, double value, const Limits& limits)
    {
        const std::size_t before = this->state().problems.size();
        if (limits.isTooLittle(value))
            report(key, limits.tooLittle, limits.least);
        else if (limits.isTooMuch(value))
            report(key, limits.tooMuch, limits.greatest);
        else if (!std::isfinite(value))
            invalid(key, quoted(key) + " is not a finite number");
        return this->state().problems.size() == before;
    }

    void report(const std::string& key, const Limits::Sentence& sentence, double limit)
    {
        if (sentence.reason == nullptr)
            return;
        std::string reason = sentence.reason;
        if (sentence.unit != nullptr)
            reason += " has at most " + std::to_string(std::llround(limit)) + " " + sentence.unit;
        invalid(key, std::move(reason), sentence.remedy);
    }

    std::set<std::string>* m_names = nullptr;
};

} // namespace

void checkFields(const Project& project, ProjectProblems& problems)
{
    CheckState state{project, problems};
    FieldChecker<const Project> checker(project, "", state);
    describe(checker, Type<Project>());
}

} // namespace quadrille
