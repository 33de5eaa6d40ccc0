// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/framenote.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace quadrille {

namespace {

constexpr auto notesKey = "notes";

} // namespace

std::vector<FrameNote> notesOf(const UnknownKeys& entry)
{
    std::vector<FrameNote> notes;
    if (!entry.contains(notesKey))
        return notes;
    for (const nlohmann::ordered_json& json : entry.json()[notesKey]) {
        FrameNote& note = notes.emplace_back();
        nlohmann::ordered_json unknown;
        for (const auto& [key, value] : json.items()) {
            if (key == "frame")
                note.frame = FrameIndex(value.get<std::int64_t>());
            else if (key == "text")
                note.text = value.get<std::string>();
            else
                unknown[key] = value;
        }
        note.unknown = UnknownKeys(std::move(unknown));
    }
    std::ranges::stable_sort(notes, {}, &FrameNote::frame);
    return notes;
}

void setNotes(UnknownKeys& entry, std::vector<FrameNote> notes)
{
    nlohmann::ordered_json kept = entry.json();
    if (kept.is_object())
        kept.erase(notesKey);
    std::ranges::stable_sort(notes, {}, &FrameNote::frame);
    for (const FrameNote& note : notes) {
        nlohmann::ordered_json json = nlohmann::ordered_json::object();
        json["frame"] = note.frame.value;
        json["text"] = note.text;
        addUnknown(json, note.unknown);
        kept[notesKey].push_back(std::move(json));
    }
    entry = kept.empty() ? UnknownKeys() : UnknownKeys(std::move(kept));
}

} // namespace quadrille
