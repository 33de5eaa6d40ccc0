// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/schema.h"

#include "model/project/fields/shareddefinitions.h"
#include "model/project/fields/visitor.h"
#include "model/project/json/jsontext.h"

#include <cmath>
#include <limits>
#include <variant>

namespace quadrille {

namespace {

/// A number without a fraction where it has none.
Json tidy(double number)
{
    const bool isWhole = number == std::floor(number) && std::abs(number) < 1e15;
    return isWhole ? Json(static_cast<std::int64_t>(number)) : Json(number);
}

Json referenceTo(const std::string& definition)
{
    return {{"$ref", "#/definitions/" + definition}};
}

Json described(const char* help)
{
    Json json = Json::object();
    if (*help != '\0')
        json["description"] = help;
    return json;
}

void addLimits(Json& json, const FieldInfo& info)
{
    const Limits& limits = info.limits;
    if (std::isfinite(limits.least))
        json[limits.isAboveLeast ? "exclusiveMinimum" : "minimum"] = tidy(limits.least);
    else if (info.role == Role::Count || info.role == Role::Seed)
        json["minimum"] = 0;
    if (std::isfinite(limits.greatest))
        json[limits.isBelowGreatest ? "exclusiveMaximum" : "maximum"] = tidy(limits.greatest);
}

Json textSchema(const FieldInfo& info)
{
    if (info.role == Role::Name)
        return referenceTo("name");
    Json json = described(info.help);
    for (const std::string_view choice : info.choices)
        json["enum"].push_back(choice);
    if (!info.choices.empty())
        return json;
    json["type"] = "string";
    if (info.need == Need::Required)
        json["minLength"] = 1;
    return json;
}

/// Makes the definition of an entry, and those of all that it holds.
template <typename Entry>
class SchemaWriter : public FieldVisitor<SchemaWriter<Entry>>
{
public:
    /// \param definitions  of the schema; gets that of the entry under the name that it has.
    explicit SchemaWriter(Json& definitions) : m_definitions(definitions) {}

    /// Adds the definition. \return its name.
    const std::string& finish()
    {
        Json& own = m_definitions[m_name];
        own = described(m_help.c_str());
        own["type"] = "object";
        if (!m_required.empty())
            own["required"] = m_required;
        for (const auto& [key, value] : m_more.items())
            own[key] = value;
        own["properties"] = m_properties;
        return m_name;
    }
    const Json& properties() const { return m_properties; }
    const Json& required() const { return m_required; }

    void about(const char* name, const char* help = "")
    {
        m_name = name;
        m_help = help;
    }
    void kind(const char* name, const char* help)
    {
        about(name, help);
        m_properties["kind"]["enum"] = {name};
        m_required.push_back("kind");
    }
    void constant(const char* key, const Json& value)
    {
        m_properties[key]["const"] = value;
        m_required.push_back(key);
    }

    template <typename Member>
    void field(const char* key, Member member, const FieldInfo& info = {})
    {
        const auto& usual = memberOf(m_usual, member);
        using Value = PlainMember<Entry, Member>;
        if constexpr (isNumber<Value>) {
            addNumber(key, usual, info);
        } else if constexpr (std::is_same_v<Value, std::string>) {
            add(key, textSchema(info), info);
        } else if constexpr (std::is_same_v<Value, bool>) {
            Json json = described(info.help);
            json["type"] = "boolean";
            json["default"] = usual;
            add(key, std::move(json), info);
        } else if constexpr (std::is_same_v<Value, FrameRange>) {
            add(key, referenceTo("range"), info);
        } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            addList(key, {{"type", "string"}}, info);
        } else if constexpr (std::is_same_v<Value, std::vector<double>> || isListOfWholes<Value>) {
            addNumbers(key, usual, info);
        } else if constexpr (std::is_same_v<Value, std::vector<JunctionEntry>>) {
            addList(key, referenceTo("junction"), info);
        } else {
            valueSchema(m_properties, key, Type<std::remove_cvref_t<decltype(usual)>>());
            if (info.need == Need::Required)
                m_required.push_back(key);
            if constexpr (std::is_same_v<Value, ObstacleEntry>)
                m_more["anyOf"] = {{{"required", {"centre", "radius"}}}, {{"required", {"polygon"}}}};
            if constexpr (std::is_same_v<Value, ExportEntry>)
                define<RenderSettings>();
        }
    }
    template <typename Member, typename Words>
    void word(const char* key, Member member, const Words& words, const FieldInfo& info)
    {
        Json json = described(info.help);
        for (const auto& [word, meant] : words)
            json["enum"].push_back(word);
        for (const auto& [word, meant] : words) {
            if (meant == memberOf(m_usual, member))
                json["default"] = word;
        }
        add(key, std::move(json), info);
    }
    template <typename Member>
    void choice(Member, const FieldInfo& info = {})
    {
        m_properties["label"]["type"] = "string";
        m_properties["sequence"]["type"] = "string";
        m_properties["range"] = referenceTo("range");
        if (info.need == Need::Required)
            m_more["anyOf"] = {{{"required", {"label"}}}, {{"required", {"sequence"}}}};
    }
    template <typename Member, typename Name, typename Unknown>
    void spans(const char* key, Member, const char* nameKey, Name, Unknown, const char* help)
    {
        const std::string name(nameKey);
        Json span = described(help);
        span["type"] = "object";
        span["required"] = {name, "frames"};
        span["properties"] = {{name, {{"type", "string"}, {"minLength", 1}}},
                              {"frames", referenceTo("range")}};
        const std::string definition = name == "foot" ? "contact" : name;
        m_definitions[definition] = std::move(span);
        addList(key, referenceTo(definition), {});
    }
    template <typename Member, typename Unknown = std::nullptr_t>
    void object(const char* key, Member, const FieldInfo& info = {}, Unknown = nullptr)
    {
        Json json = described(info.help);
        json["$ref"] = "#/definitions/" + define<PlainMember<Entry, Member>>();
        add(key, std::move(json), info);
    }
    template <typename Member, typename Unknown = std::nullptr_t>
    void step(const char* key, Member member, const FieldInfo& info = {}, Unknown = nullptr)
    {
        add(key,
            {{"anyOf", {{{"type", "boolean"}}, referenceTo(define<PlainMember<Entry, Member>>())}},
             {"default", memberOf(m_usual, member).has_value()}},
            info);
    }
    template <typename Unknown, typename Fields>
    void group(const char* key, const char* name, const char* help, Unknown, const Fields& fields)
    {
        SchemaWriter own(m_definitions);
        own.about(name, help);
        fields(own);
        m_properties[key] = referenceTo(own.finish());
    }
    template <typename Member>
    void list(const char* key, Member, const FieldInfo& info = {})
    {
        addList(key, item<Member>(info), info);
    }
    template <typename Member>
    void perCharacter(const char* key, Member, const FieldInfo& info)
    {
        const Json one = item<Member>(info);
        Json json = described(info.help);
        json["anyOf"] = {one, {{"type", "array"}, {"items", one}}};
        add(key, std::move(json), info);
    }
    template <typename Member>
    void variants(const char* key, Member)
    {
        using List = PlainMember<Entry, Member>;
        Json item{{"type", "object"}, {"required", {"kind"}}};
        addKinds(item, Type<typename List::value_type>());
        addList(key, std::move(item), {});
    }

private:
    template <typename Child>
    std::string define()
    {
        SchemaWriter<Child> writer(m_definitions);
        describe(writer, Type<Child>());
        return writer.finish();
    }

    /// The schema of one item of a list of entries.
    template <typename Member>
    Json item(const FieldInfo& info)
    {
        const std::string name = define<typename PlainMember<Entry, Member>::value_type>();
        if (info.shortKey == nullptr)
            return referenceTo(name);
        return {{"anyOf", {m_definitions[name]["properties"][info.shortKey], referenceTo(name)}}};
    }

    template <typename... Kinds>
    void addKinds(Json& item, Type<std::variant<Kinds...>>)
    {
        (item["anyOf"].push_back(referenceTo(define<Kinds>())), ...);
    }

    template <typename Value>
    void addNumber(const char* key, const Value& usual, const FieldInfo& info)
    {
        Json json = described(info.help);
        json["type"] = isWhole<typename Plain<Value>::Type> ? "integer" : "number";
        addLimits(json, info);
        if constexpr (!IsOptional<Value>::value) {
            if (info.need != Need::Required)
                json["default"] = tidy(static_cast<double>(bare(usual)));
        } else if (info.fallback) {
            json["default"] = tidy(*info.fallback);
        }
        add(key, std::move(json), info);
    }

    template <typename Number>
    void addNumbers(const char* key, const std::vector<Number>& usual, FieldInfo info)
    {
        if (isWhole<Number> && !std::isfinite(info.limits.least))
            info.limits = Limits::from(0, nullptr);
        Json item{{"type", isWhole<Number> ? "integer" : "number"}};
        addLimits(item, info);
        addList(key, std::move(item), info);
        std::vector<double> numbers(info.fallbackList.begin(), info.fallbackList.end());
        for (const Number& number : usual)
            numbers.push_back(static_cast<double>(bare(number)));
        if (!numbers.empty())
            m_properties[key]["default"] = numbers;
    }

    void addList(const char* key, Json item, const FieldInfo& info)
    {
        Json json = described(info.help);
        json["type"] = "array";
        json["items"] = std::move(item);
        if (info.leastItems > 0)
            json["minItems"] = info.leastItems;
        add(key, std::move(json), info);
    }

    void add(const char* key, Json json, const FieldInfo& info)
    {
        m_properties[key] = std::move(json);
        if (info.need == Need::Required || info.leastItems > 0)
            m_required.push_back(key);
    }

    Json& m_definitions;
    const Entry m_usual{};
    std::string m_name;
    std::string m_help;
    Json m_properties = Json::object();
    Json m_required = Json::array();
    Json m_more = Json::object();
};

} // namespace

Json projectSchema()
{
    Json definitions = Json::parse(sharedDefinitions);
    SchemaWriter<Project> writer(definitions);
    describe(writer, Type<Project>());
    Json schema = Json::object();
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["$id"] = "quadrille-project.schema.json";
    schema["title"] = "Quadrille project";
    schema["description"] =
        "A project of Quadrille (NAME.quadrille), version " + std::to_string(Project::currentVersion) +
        ". Paths are relative to the file, with forward slashes. Unknown keys are allowed "
        "everywhere and kept.";
    schema["type"] = "object";
    schema["required"] = writer.required();
    schema["properties"] = writer.properties();
    schema["definitions"] = std::move(definitions);
    return schema;
}

NumberFacts factsOf(std::string_view path)
{
    static const Json definitions = projectSchema()["definitions"];
    const auto dot = path.find('.');
    const Json& member = definitions.at(std::string(path.substr(0, dot)))
                             .at("properties")
                             .at(std::string(path.substr(dot + 1)));
    // Where a word may stand for it, the number comes first.
    const Json& number = member.contains("oneOf") ? member["oneOf"].front() : member;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    NumberFacts facts{.least = number.value("minimum", number.value("exclusiveMinimum", -infinity)),
                      .isAboveLeast = number.contains("exclusiveMinimum"),
                      .greatest = number.value("maximum", number.value("exclusiveMaximum", infinity)),
                      .usual = {}};
    if (member.contains("default") && member["default"].is_number())
        facts.usual = member["default"].get<double>();
    return facts;
}

} // namespace quadrille
