// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/media/sequencesettings.h"

#include "model/project/document/findentry.h"
#include "model/project/document/paths.h"

#include <nlohmann/json.hpp>

namespace quadrille {

namespace {

nlohmann::json axesJson(const CoordinateSystem& axes)
{
    return {toString(axes.up), axes.metresPerUnit};
}

nlohmann::json settingsJson(const Project& project, const SequenceEntry& entry)
{
    nlohmann::json json;
    json["fps"] = project.settings.fps;
    json["axes"] = axesJson(project.settings.axes);
    if (entry.range)
        json["range"] = {entry.range->first.value, entry.range->last.value};
    if (const auto clip = clipOfSource(entry.source)) {
        // The clip of an animation is an input by itself.
        const auto name = nameOfClip(*clip, "sequences");
        const SequenceEntry* source = name ? findSequence(project, *name) : nullptr;
        json["clip_source"] = source ? settingsJson(project, *source) : nlohmann::json();
        return json;
    }
    json["clip"] = entry.clip;
    json["source_fps"] = entry.sourceFps.value_or(project.settings.fps);
    if (entry.sourceAxes)
        json["source_axes"] = axesJson(*entry.sourceAxes);
    const CharacterEntry* character = characterOf(project, entry);
    const bool ownTexture = entry.texture.kind != TextureReference::Kind::None;
    json["texture"] =
        static_cast<int>(ownTexture || !character ? entry.texture.kind : character->texture.kind);
    return json;
}

} // namespace

std::string sequenceSettings(const Project& project, const SequenceEntry& entry)
{
    return settingsJson(project, entry).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string sequenceSettings(const Project& project, const std::vector<std::string>& names)
{
    std::string settings;
    for (const std::string& name : names)
        settings += nlohmann::json(name).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) +
                    sequenceSettings(project, *findSequence(project, name));
    return settings;
}

std::string contactSettings(const SequenceEntry& entry)
{
    nlohmann::json contacts = nlohmann::json::array();
    for (const ContactSpan& span : entry.contacts)
        contacts.push_back({span.foot, span.frames.first.value, span.frames.last.value});
    return contacts.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

} // namespace quadrille
