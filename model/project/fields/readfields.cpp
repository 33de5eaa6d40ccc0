// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/readfields.h"

#include "model/project/fields/visitor.h"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <variant>

namespace quadrille {

namespace {

template <typename Entry>
void readEntry(const ObjectReader& reader, Entry& entry, const FieldContext& context,
               UnknownKeys* unknown = nullptr);

/// Takes the name of one kind of an entry.
struct KindName : FieldVisitor<KindName>
{
    void kind(const char* own, const char*) { name = own; }
    const char* name = "";
};

template <typename Entry>
const char* nameOf(Type<Entry> type)
{
    KindName kind;
    describe(kind, type);
    return kind.name;
}

/// Takes the members that are described out of an object.
template <typename Entry>
class FieldReader : public FieldVisitor<FieldReader<Entry>>
{
public:
    FieldReader(const ObjectReader& reader, Entry& entry, const FieldContext& context, UnknownKeys* unknown)
        : m_reader(reader), m_entry(entry), m_context(context), m_unknown(unknown)
    {
        constexpr std::size_t usualKeys = 16;
        m_keys.reserve(usualKeys);
    }

    void constant(const char* key, const Json&) { m_keys.emplace_back(key); }
    void kind(const char*, const char*) { m_keys.emplace_back("kind"); }

    template <typename Member>
    void field(const char* key, Member member, const FieldInfo& info = {})
    {
        known(key, info);
        auto& value = memberOf(m_entry, member);
        using Value = PlainMember<Entry, Member>;
        if constexpr (isNumber<Value>)
            readNumber(key, value, info);
        else if constexpr (std::is_same_v<Value, std::string>)
            value = m_reader.text(key);
        else if constexpr (std::is_same_v<Value, bool>)
            value = m_reader.boolean(key, value);
        else if constexpr (std::is_same_v<Value, FrameRange>)
            readRange(key, value);
        else if constexpr (std::is_same_v<Value, std::vector<std::string>>)
            value = m_reader.texts(key, info.expected);
        else if constexpr (std::is_same_v<Value, std::vector<double>>)
            value = m_reader.numbers(key, 0, "a list of numbers").value_or(value);
        else if constexpr (isListOfWholes<Value>)
            for (const int number : m_reader.wholeNumbers(key))
                value.emplace_back(number);
        else if constexpr (std::is_same_v<Value, std::vector<JunctionEntry>>)
            value = m_reader.junctions(key);
        else
            readCodec(key, value);
    }

    template <typename Member, typename Words>
    void word(const char* key, Member member, const Words& words, const FieldInfo& info)
    {
        known(key, info);
        m_reader.word(key, memberOf(m_entry, member), words);
    }

    template <typename Member>
    void choice(Member member, const FieldInfo& info = {})
    {
        for (const char* key : {"label", "sequence", "range"})
            m_keys.emplace_back(key);
        auto& value = memberOf(m_entry, member);
        if (auto choice = m_reader.choice())
            value = std::move(*choice);
        else if (info.need == Need::Required)
            m_reader.invalid(m_reader.pointer(), "The action names no movement",
                             "Give a “label” or a “sequence”.");
    }

    template <typename Member, typename Name, typename Unknown>
    void spans(const char* key, Member member, const char* nameKey, Name name, Unknown unknownOfSpans,
               const char*)
    {
        known(key, {});
        Json withUnknown;
        m_reader.each(key, [&](const Json& json, const std::string& pointer) {
            const ObjectReader own(json, pointer, m_reader.problems());
            auto& span = memberOf(m_entry, member).emplace_back();
            span.*name = own.requiredText(nameKey);
            if (own.find("frames") == nullptr)
                own.missing("frames");
            span.frames = own.range("frames").value_or(FrameRange{});
            if (!own.unknown({nameKey, "frames"}).is_null())
                withUnknown.push_back(json);
        });
        if (!withUnknown.is_null())
            memberOf(m_entry, unknownOfSpans).set(key, std::move(withUnknown));
    }

    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char* key, Member member, const FieldInfo& info = {}, Unknown unknown = nullptr)
    {
        known(key, info);
        if (const Json* json = m_reader.find(key))
            readInto(memberOf(m_entry, member), {*json, m_reader.pointer(key), m_reader.problems()}, unknown);
    }

    template <typename Member, typename Unknown = std::nullptr_t>
    void step(const char* key, Member member, const FieldInfo& info = {}, Unknown unknown = nullptr)
    {
        auto& value = memberOf(m_entry, member);
        const Json* json = m_reader.find(key);
        if (json != nullptr && json->is_object()) {
            value.emplace();
            object(key, member, info, unknown);
            return;
        }
        known(key, info);
        const bool isWanted = m_reader.boolean(key, value.has_value());
        if (isWanted != value.has_value())
            value = isWanted ? std::optional(PlainMember<Entry, Member>()) : std::nullopt;
    }

    template <typename Unknown, typename Fields>
    void group(const char* key, const char*, const char*, Unknown unknown, const Fields& fields)
    {
        known(key, {});
        const Json* json = m_reader.find(key);
        if (json == nullptr)
            return;
        const ObjectReader reader(*json, m_reader.pointer(key), m_reader.problems());
        FieldReader own(reader, m_entry, m_context, &memberOf(m_entry, unknown));
        fields(own);
        own.finish();
    }

    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& info = {})
    {
        known(key, info);
        m_reader.each(key, [&](const Json& json, const std::string& pointer) {
            addItem(memberOf(m_entry, member), json, pointer, info);
        });
    }

    template <typename Member>
    void perCharacter(const char* key, Member member, const FieldInfo& info)
    {
        const Json* one = m_reader.find(key);
        if (one == nullptr || !one->is_object())
            return list(key, member, info);
        known(key, info);
        addItem(memberOf(m_entry, member), *one, m_reader.pointer(key), info);
    }

    template <typename Member>
    void variants(const char* key, Member member)
    {
        known(key, {});
        m_reader.each(key, [&](const Json& json, const std::string& pointer) {
            addVariant(memberOf(m_entry, member), {json, pointer, m_reader.problems()});
        });
    }

    template <typename Member>
    void unknown(Member member)
    {
        m_unknown = &memberOf(m_entry, member);
    }

    /// Those of the members that are described, in their order.
    const std::vector<std::string>& keys() const { return m_keys; }

    /// Keeps and reports what no member has taken.
    void finish() const
    {
        const std::vector<std::string_view> keys(m_keys.begin(), m_keys.end());
        Json rest = m_reader.unknown(keys);
        if (m_unknown == nullptr)
            return;
        for (const auto& [key, value] : m_unknown->json().items()) // notes
            rest[key] = value;
        *m_unknown = UnknownKeys(std::move(rest));
    }

private:
    void known(const char* key, const FieldInfo& info)
    {
        m_keys.emplace_back(key);
        if (info.need == Need::Required && m_reader.isObject() && m_reader.find(key) == nullptr)
            m_reader.missing(key);
    }

    template <typename Value>
    void readNumber(const char* key, Value& value, const FieldInfo& info) const
    {
        using Number = typename Plain<Value>::Type;
        std::optional<double> number;
        if constexpr (isWhole<Number>)
            number = info.role == Role::Seed ? m_reader.wholeNumber(key, limits::seed.greatest + 1)
                                             : m_reader.wholeNumber(key);
        else
            number = m_reader.number(key);
        if (!number)
            return;
        const bool fits = !info.limits.isTooLittle(*number) && !info.limits.isTooMuch(*number);
        if (info.expected != nullptr && !fits)
            m_reader.wrongType(key, info.expected);
        else if (info.role == Role::Count && (*number < 0 || *number > 1e6))
            m_reader.wrongType(key, "a whole number from zero to a million");
        else if (info.role == Role::Seed && *number < 0)
            m_reader.wrongType(key, "a whole number from zero");
        else
            value = Number{static_cast<decltype(bare(Number()))>(*number)};
    }

    template <typename Range>
    void readRange(const char* key, Range& value) const
    {
        if (const auto range = m_reader.range(key))
            value = *range;
    }

    template <typename Value>
    void readCodec(const char* key, Value& value)
    {
        for (std::string& own : valueKeys(key, Type<Value>()))
            m_keys.push_back(std::move(own));
        readValue(m_reader, key, value, m_context);
    }

    template <typename Value, typename Unknown>
    void readInto(Value& value, const ObjectReader& reader, Unknown unknown)
    {
        UnknownKeys* keys = nullptr;
        if constexpr (!std::is_null_pointer_v<Unknown>)
            keys = &memberOf(m_entry, unknown);
        if constexpr (IsOptional<Value>::value) {
            readEntry(reader, value ? *value : value.emplace(), m_context, keys);
            if constexpr (requires { value->saysNothing(); }) {
                if (value->saysNothing())
                    value.reset();
            }
        } else {
            readEntry(reader, value, m_context, keys);
        }
    }

    template <typename Item>
    void addItem(std::vector<Item>& items, const Json& json, const std::string& pointer,
                 const FieldInfo& info)
    {
        const bool isShort = info.shortKey != nullptr && json.is_string();
        const Json whole = isShort ? Json{{info.shortKey, json}} : Json();
        readEntry(ObjectReader(isShort ? whole : json, pointer, m_reader.problems()), items.emplace_back(),
                  m_context);
    }

    template <typename... Kinds>
    void addVariant(std::vector<std::variant<Kinds...>>& items, const ObjectReader& reader)
    {
        if (reader.find("kind") == nullptr)
            reader.missing("kind");
        std::size_t kind = sizeof...(Kinds);
        reader.word("kind", kind, kindWords(std::index_sequence_for<Kinds...>(), Type<Kinds>()...));
        std::size_t index = 0;
        const auto add = [&](auto entry) {
            if (index++ != kind)
                return;
            readEntry(reader, entry, m_context);
            items.emplace_back(std::move(entry));
        };
        (add(Kinds()), ...);
    }

    template <std::size_t... indices, typename... Kinds>
    static std::array<std::pair<const char*, std::size_t>, sizeof...(Kinds)>
    kindWords(std::index_sequence<indices...>, Type<Kinds>... kinds)
    {
        return {std::pair(nameOf(kinds), indices)...};
    }

    const ObjectReader& m_reader;
    Entry& m_entry;
    const FieldContext& m_context;
    UnknownKeys* m_unknown;
    std::vector<std::string> m_keys;
};

template <typename Entry>
void readEntry(const ObjectReader& reader, Entry& entry, const FieldContext& context, UnknownKeys* unknown)
{
    FieldReader<Entry> fields(reader, entry, context, unknown);
    describe(fields, Type<Entry>());
    fields.finish();
}

} // namespace

Project readFields(const ObjectReader& reader)
{
    Project project;
    readEntry(reader, project, {project.settings.axes});
    return project;
}

std::vector<std::string> documentKeys()
{
    Project project;
    ProjectProblems problems;
    const Json empty = Json::object();
    const ObjectReader reader(empty, "", problems);
    FieldReader<Project> fields(reader, project, {project.settings.axes}, nullptr);
    describe(fields, Type<Project>());
    return fields.keys();
}

void readFields(const ObjectReader& reader, RenderSettings& settings)
{
    readEntry(reader, settings, {CoordinateSystem()});
}

} // namespace quadrille
