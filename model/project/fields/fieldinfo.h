// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace quadrille {

/// What a number of the project file may be, and what is said of one that may not. A constexpr value, built
/// as `from(0, "Alpha is below zero").upTo(60, "The dwell", "seconds")`.
struct Limits
{
    struct Sentence
    {
        const char* reason = nullptr; ///< without the full stop
        const char* remedy = "";      ///< a sentence, or empty
        const char* unit = nullptr;   ///< then `reason` is the subject of "… has at most N UNIT"
    };
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
    bool isAboveLeast = false;    ///< least itself is too little
    bool isBelowGreatest = false; ///< greatest itself is too much
    Sentence tooLittle;
    Sentence tooMuch;

    static constexpr Limits from(double least, const char* reason, const char* remedy = "")
    {
        Limits limits;
        limits.least = least;
        limits.tooLittle = {reason, remedy};
        return limits;
    }
    static constexpr Limits above(double least, const char* reason, const char* remedy = "")
    {
        Limits limits = from(least, reason, remedy);
        limits.isAboveLeast = true;
        return limits;
    }
    /// Both ends included, with one sentence for both.
    static constexpr Limits between(double least, double greatest, const char* reason,
                                    const char* remedy = "")
    {
        return from(least, reason, remedy).upTo(greatest, {reason, remedy});
    }
    /// Ends excluded.
    static constexpr Limits within(double least, double greatest, const char* reason, const char* remedy = "")
    {
        Limits limits = between(least, greatest, reason, remedy);
        limits.isAboveLeast = limits.isBelowGreatest = true;
        return limits;
    }

    constexpr Limits upTo(double most, const char* subject, const char* unit,
                          const char* remedy = "Write less.") const
    {
        Limits limits = *this;
        limits.greatest = most;
        limits.tooMuch = {subject, remedy, unit};
        return limits;
    }
    constexpr Limits upTo(double most, Sentence sentence) const
    {
        Limits limits = *this;
        limits.greatest = most;
        limits.tooMuch = sentence;
        return limits;
    }

    bool isTooLittle(double value) const { return isAboveLeast ? !(value > least) : !(value >= least); }
    bool isTooMuch(double value) const
    {
        return isBelowGreatest ? !(value < greatest) : !(value <= greatest);
    }
};

/// Whether a member of the file must be there, and is written where it says nothing new.
enum class Need
{
    Optional, ///< may be left out, and is where it is empty or as usual
    Always,   ///< may be left out, but is written
    Required, ///< must be there
};

/// What goes with a name that is no more.
enum class Loss
{
    OfWhatNeedsIt, ///< the owner where the member is required, else the member; an item of a list
    OfOwner,       ///< of a list: once no item is left
    OfWhole,       ///< of a list: all items, where one of them is lost
};

/// What other entries of a project speak of by name.
enum class NamedKind
{
    Character,
    Sequence,
    Animation,
    Variation,
    MotionSpace,
    Live,
    Transfer,
    Projection,
};

/// What a text or a number stands for.
enum class Role
{
    None,
    Name,      ///< of the entry
    File,      ///< a file, folder or pattern that is read
    Output,    ///< a file that is written
    Source,    ///< a file, or a clip as “clip:SECTION/NAME”
    Clip,      ///< “SECTION/NAME”
    Character, ///< that an entry is of; may be left out where there is one
    Reference, ///< the name of another entry
    Count,     ///< from zero to a million
    Seed,
};

/// What is known of a member of the project file beside its key, kind and place in its entry.
struct FieldInfo
{
    const char* help = ""; ///< for the schema: a sentence or two
    Need need = Need::Optional;
    Role role = Role::None;
    NamedKind kind = NamedKind::Sequence; ///< of what is referred to
    bool isAnyOfProject = false; ///< the name of any sequence will do; what else is asked is checked by hand
    Limits limits = {};
    /// A number that is out of limits has a wrong type: it “must be …”, and is not taken. Of lists: what an
    /// item must be, a sentence.
    const char* expected = nullptr;
    std::optional<double> fallback = {};            ///< what counts where an optional number is left out
    std::span<const double> fallbackList = {};      ///< what counts where a list of numbers is
    std::span<const std::string_view> choices = {}; ///< the texts that are known
    Loss loss = Loss::OfWhatNeedsIt;
    const char* shortKey = nullptr; ///< an object may stand as the text of this member alone
    std::size_t leastItems = 0;     ///< of a list; where there are any it must be there
};

} // namespace quadrille
