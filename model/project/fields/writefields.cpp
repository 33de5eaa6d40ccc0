// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/writefields.h"

#include "model/project/document/framenote.h"
#include "model/project/fields/visitor.h"
#include "model/project/json/jsonmembers.h"
#include "model/project/json/jsontext.h"

#include <algorithm>
#include <variant>

namespace quadrille {

namespace {

template <typename Entry>
Json toJson(const Entry& entry, const FieldContext& context, const UnknownKeys* unknown = nullptr);

template <typename Value>
Json plainJson(const Value& value)
{
    return bare(value);
}
Json plainJson(FrameRange range)
{
    return rangeToJson(range);
}
Json plainJson(const NamedFrame& frame)
{
    return Json::array({frame.sequence, frame.frame.value});
}
Json plainJson(const JunctionEntry& junction)
{
    return Json::array({plainJson(junction.from), plainJson(junction.to)});
}
template <typename Item>
Json plainJson(const std::vector<Item>& items)
{
    Json list = Json::array();
    for (const Item& item : items)
        list.push_back(plainJson(item));
    return list;
}

/// Adds the members that are described to an object.
template <typename Entry>
class FieldWriter : public FieldVisitor<FieldWriter<Entry>>
{
public:
    FieldWriter(Json& json, const Entry& entry, const FieldContext& context)
        : m_json(json), m_entry(entry), m_context(context)
    {
    }

    void constant(const char* key, const Json& value) { m_json[key] = value; }
    void kind(const char* name, const char*) { m_json["kind"] = name; }

    template <typename Member>
    void field(const char* key, Member member, const FieldInfo& info = {})
    {
        const auto& value = memberOf(m_entry, member);
        using Value = std::remove_cvref_t<decltype(value)>;
        if constexpr (requires { valueSchema(m_json, key, Type<Value>()); })
            writeValue(m_json, key, value, m_context);
        else if constexpr (IsOptional<Value>::value)
            addOptional(m_json, key, value ? std::optional(plainJson(*value)) : std::nullopt);
        else if (info.need != Need::Optional || !(value == memberOf(usual(), member)))
            m_json[key] = plainJson(value);
    }

    template <typename Member, typename Words>
    void word(const char* key, Member member, const Words& words, const FieldInfo& info)
    {
        const auto& value = memberOf(m_entry, member);
        const auto found = std::ranges::find(words, value, [](const auto& word) { return word.second; });
        if (info.need != Need::Optional || value != memberOf(usual(), member))
            m_json[key] = found->first;
    }

    template <typename Member>
    void choice(Member member, const FieldInfo& = {})
    {
        const std::optional<FrameChoice> choice = memberOf(m_entry, member);
        if (!choice)
            return;
        addText(m_json, "label", choice->label);
        addText(m_json, "sequence", choice->sequence);
        if (choice->range)
            m_json["range"] = rangeToJson(*choice->range);
    }

    template <typename Member, typename Name, typename Unknown>
    void spans(const char* key, Member member, const char* nameKey, Name name, Unknown unknownOfSpans,
               const char*)
    {
        const Json& read = memberOf(m_entry, unknownOfSpans).json();
        for (const auto& span : memberOf(m_entry, member)) {
            Json item = Json::object();
            item[nameKey] = span.*name;
            item["frames"] = rangeToJson(span.frames);
            if (read.is_object() && read.contains(key)) {
                for (const Json& whole : read[key]) {
                    if (whole[nameKey] == item[nameKey] && whole["frames"] == item["frames"])
                        addUnknown(item, whole);
                }
            }
            m_json[key].push_back(std::move(item));
        }
    }

    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char* key, Member member, const FieldInfo& info = {}, Unknown unknown = nullptr)
    {
        const auto& value = memberOf(m_entry, member);
        if constexpr (IsOptional<std::remove_cvref_t<decltype(value)>>::value) {
            if (value)
                m_json[key] = toJson(*value, m_context, keysOf(unknown));
        } else {
            Json json = toJson(value, m_context, keysOf(unknown));
            if (!json.empty() || info.need != Need::Optional)
                m_json[key] = std::move(json);
        }
    }

    template <typename Member, typename Unknown = std::nullptr_t>
    void step(const char* key, Member member, const FieldInfo& = {}, Unknown unknown = nullptr)
    {
        const auto& value = memberOf(m_entry, member);
        const bool isUsual = memberOf(usual(), member).has_value();
        if (!value) {
            if (isUsual)
                m_json[key] = false;
            return;
        }
        Json json = toJson(*value, m_context, keysOf(unknown));
        if (!json.empty())
            m_json[key] = std::move(json);
        else if (!isUsual)
            m_json[key] = true;
    }

    template <typename Unknown, typename Fields>
    void group(const char* key, const char*, const char*, Unknown unknown, const Fields& fields)
    {
        Json json = Json::object();
        FieldWriter own(json, m_entry, m_context);
        fields(own);
        addUnknown(json, memberOf(m_entry, unknown));
        if (!json.empty())
            m_json[key] = std::move(json);
    }

    template <typename Member>
    void list(const char* key, Member member, const FieldInfo& info = {})
    {
        const auto& items = memberOf(m_entry, member);
        if (items.empty() && info.need == Need::Optional)
            return;
        Json& list = m_json[key] = Json::array();
        for (const auto& item : items) {
            Json json = toJson(item, m_context);
            const bool isShort = info.shortKey != nullptr && json.size() == 1;
            list.push_back(isShort ? json[info.shortKey] : json);
        }
    }

    template <typename Member>
    void perCharacter(const char* key, Member member, const FieldInfo& info)
    {
        const auto& items = memberOf(m_entry, member);
        if (items.size() == 1 && items.front().character.empty())
            m_json[key] = toJson(items.front(), m_context);
        else
            list(key, member, info);
    }

    template <typename Member>
    void variants(const char* key, Member member)
    {
        for (const auto& item : memberOf(m_entry, member))
            m_json[key].push_back(
                std::visit([&](const auto& entry) { return toJson(entry, m_context); }, item));
    }

    template <typename Member>
    void unknown(Member member)
    {
        addUnknown(m_json, memberOf(m_entry, member));
    }

private:
    /// A new entry.
    static const Entry& usual()
    {
        static const Entry entry{};
        return entry;
    }

    template <typename Unknown>
    const UnknownKeys* keysOf(Unknown unknown) const
    {
        if constexpr (std::is_null_pointer_v<Unknown>)
            return nullptr;
        else
            return &memberOf(m_entry, unknown);
    }

    Json& m_json;
    const Entry& m_entry;
    const FieldContext& m_context;
};

template <typename Entry>
Json toJson(const Entry& entry, const FieldContext& context, const UnknownKeys* unknown)
{
    Json json = Json::object();
    FieldWriter<Entry> fields(json, entry, context);
    describe(fields, Type<Entry>());
    if (unknown != nullptr)
        addUnknown(json, *unknown);
    return json;
}

/// In ASCII, whatever bytes its texts have.
std::string lineOf(const Json& json)
{
    return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

} // namespace

Json writeFields(const Project& project)
{
    return toJson(project, {project.settings.axes});
}

Json writeFields(const AnimationEntry& animation, UpAxis up)
{
    return toJson(animation, {CoordinateSystem{up, 1}});
}

Json writeFields(const RenderSettings& settings)
{
    return toJson(settings, {CoordinateSystem()});
}

std::string settingsText(const BodyPartsEntry& parts)
{
    return lineOf(toJson(parts, {CoordinateSystem()}));
}

std::string settingsText(const VariationEntry& variation)
{
    return lineOf(toJson(variation, {CoordinateSystem()}));
}

std::string settingsText(const AppearanceEntry& appearance)
{
    return toJson(appearance, {CoordinateSystem()}).dump(); // its names in UTF-8
}

std::string settingsText(const MotionSpaceEntry& space)
{
    return lineOf(toJson(space, {CoordinateSystem()}));
}

std::string settingsText(const LiveEntry& live)
{
    return lineOf(toJson(live, {CoordinateSystem()}));
}

std::string settingsText(const TransferEntry& transfer)
{
    return lineOf(toJson(transfer, {CoordinateSystem()}));
}

std::string settingsText(const ProjectionEntry& projection)
{
    return lineOf(toJson(projection, {CoordinateSystem()}));
}

std::string animationSettings(const AnimationEntry& animation, UpAxis up)
{
    AnimationEntry shown = animation;
    shown.audio.reset();
    shown.camera.clear();
    setNotes(shown.unknown, {});
    return lineOf(writeFields(shown, up));
}

} // namespace quadrille
