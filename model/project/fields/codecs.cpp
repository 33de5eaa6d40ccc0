// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/fields/codecs.h"

#include "model/project/document/framenote.h"
#include "model/project/document/lengthunit.h"
#include "model/project/fields/pictureoptions.h"
#include "model/project/json/jsonmembers.h"

#include <cmath>

namespace quadrille {

namespace {

std::optional<UpAxis> readUpAxis(const ObjectReader& reader, const std::string& key)
{
    if (reader.find(key) == nullptr)
        return std::nullopt;
    const auto axis = upAxisFromString(reader.text(key));
    if (!axis && reader.find(key)->is_string())
        reader.wrongType(key, "\"x\", \"y\" or \"z\"");
    return axis;
}

std::optional<double> readUnit(const ObjectReader& reader, const std::string& key)
{
    const Json* value = reader.find(key);
    if (value == nullptr)
        return std::nullopt;
    if (value->is_number() && value->get<double>() > 0 && std::isfinite(value->get<double>()))
        return value->get<double>();
    if (value->is_string()) {
        if (const auto metres = metresPerUnit(value->get<std::string>()))
            return metres;
    }
    reader.wrongType(key, "\"m\", \"cm\", \"mm\", \"km\", \"in\", \"ft\" or the metres that one unit has");
    return std::nullopt;
}

std::optional<CoordinateSystem> readAxes(const ObjectReader& reader, const std::string& prefix,
                                         const CoordinateSystem& usual)
{
    const auto up = readUpAxis(reader, prefix + "up_axis");
    const auto metres = readUnit(reader, prefix + "unit");
    if (!up && !metres)
        return std::nullopt;
    return CoordinateSystem{up.value_or(usual.up), metres.value_or(usual.metresPerUnit)};
}

} // namespace

std::vector<std::string> valueKeys(const std::string& key, Type<CoordinateSystem>)
{
    return {key + "up_axis", key + "unit"};
}

void readValue(const ObjectReader& reader, const std::string& key, CoordinateSystem& axes,
               const FieldContext&)
{
    axes = readAxes(reader, key, axes).value_or(axes);
}

void writeValue(Json& json, const std::string& key, const CoordinateSystem& axes, const FieldContext&)
{
    json[key + "up_axis"] = toString(axes.up);
    if (const auto name = unitName(axes.metresPerUnit))
        json[key + "unit"] = *name;
    else
        json[key + "unit"] = axes.metresPerUnit;
}

void valueSchema(Json& properties, const std::string& key, Type<CoordinateSystem>)
{
    valueSchema(properties, key, Type<std::optional<CoordinateSystem>>());
    properties[key + "up_axis"]["default"] = toString(CoordinateSystem().up);
    properties[key + "unit"]["default"] = *unitName(CoordinateSystem().metresPerUnit);
}

std::vector<std::string> valueKeys(const std::string& key, Type<std::optional<CoordinateSystem>>)
{
    return valueKeys(key, Type<CoordinateSystem>());
}

void readValue(const ObjectReader& reader, const std::string& key, std::optional<CoordinateSystem>& axes,
               const FieldContext& context)
{
    axes = readAxes(reader, key, context.axes);
}

void writeValue(Json& json, const std::string& key, const std::optional<CoordinateSystem>& axes,
                const FieldContext& context)
{
    if (axes)
        writeValue(json, key, *axes, context);
}

void valueSchema(Json& properties, const std::string& key, Type<std::optional<CoordinateSystem>>)
{
    properties[key + "up_axis"]["$ref"] = "#/definitions/up_axis";
    properties[key + "unit"]["$ref"] = "#/definitions/unit";
}

void readValue(const ObjectReader& reader, const std::string& key, TextureReference& texture,
               const FieldContext&)
{
    const Json* value = reader.find(key);
    if (value == nullptr)
        return;
    if (value->is_string()) {
        if (!value->get<std::string>().empty())
            texture = {TextureReference::Kind::Single, {value->get<std::string>()}, {}};
        return;
    }
    if (!value->is_object()) {
        reader.wrongType(key, "a file, or {\"per_frame\": …} or {\"per_material\": […]}");
        return;
    }
    const ObjectReader own(*value, reader.pointer(key), reader.problems());
    if (own.find("per_frame") != nullptr) {
        texture.kind = TextureReference::Kind::PerFrame;
        texture.paths = {own.text("per_frame")};
    } else if (own.find("per_material") != nullptr) {
        texture.kind = TextureReference::Kind::PerMaterial;
        texture.paths = own.texts("per_material", "A texture file in quotes is expected here");
    } else {
        reader.invalid(own.pointer(), "“per_frame” or “per_material” is missing here");
    }
    texture.unknown = UnknownKeys(own.unknown({"per_frame", "per_material"}));
}

void writeValue(Json& json, const std::string& key, const TextureReference& texture, const FieldContext&)
{
    switch (texture.kind) {
    case TextureReference::Kind::None:
        return;
    case TextureReference::Kind::Single:
        if (!texture.paths.empty())
            json[key] = texture.paths.front();
        return;
    case TextureReference::Kind::PerFrame:
        json[key]["per_frame"] = texture.paths.empty() ? "" : texture.paths.front();
        break;
    case TextureReference::Kind::PerMaterial:
        json[key]["per_material"] = texture.paths;
        break;
    }
    addUnknown(json[key], texture.unknown);
}

void valueSchema(Json& properties, const std::string& key, Type<TextureReference>)
{
    properties[key]["$ref"] = "#/definitions/texture";
}

void readValue(const ObjectReader& reader, const std::string& key, UnknownKeys& entry, const FieldContext&)
{
    std::vector<FrameNote> notes;
    reader.each(key, [&](const Json& json, const std::string& pointer) {
        const ObjectReader own(json, pointer, reader.problems());
        FrameNote note;
        note.text = own.requiredText("text");
        if (own.find("frame") == nullptr)
            own.missing("frame");
        note.frame = FrameIndex(own.wholeNumber("frame").value_or(0));
        if (note.frame.value < 0)
            own.invalid(own.pointer("frame"), "The frame of a note is below zero", "Count frames from 0.");
        note.unknown = UnknownKeys(own.unknown({"frame", "text"}));
        notes.push_back(std::move(note));
    });
    setNotes(entry, std::move(notes));
}

void writeValue(Json& json, const std::string& key, const UnknownKeys& entry, const FieldContext&)
{
    if (entry.contains(key))
        json[key] = entry.json()[key];
}

void valueSchema(Json& properties, const std::string& key, Type<UnknownKeys>)
{
    properties[key] = {{"type", "array"}, {"items", {{"$ref", "#/definitions/note"}}}};
}

void readValue(const ObjectReader& reader, const std::string& key, ExportEntry& entry, const FieldContext&)
{
    if (const Json* picture = reader.find(key)) {
        entry.picture = UnknownKeys(*picture);
        pictureFromJson(entry.picture, reader.pointer(key), reader.problems());
    }
}

void writeValue(Json& json, const std::string& key, const ExportEntry& entry, const FieldContext&)
{
    if (!entry.picture.isNone())
        json[key] = entry.picture.json();
}

void valueSchema(Json& properties, const std::string& key, Type<ExportEntry>)
{
    properties[key]["$ref"] = "#/definitions/picture";
}

} // namespace quadrille
