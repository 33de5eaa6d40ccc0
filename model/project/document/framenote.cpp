// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/framenote.h"

#include "model/project/file/jsonmembers.h"

#include <algorithm>

namespace quadrille {

namespace {

constexpr auto notesKey = "notes";

} // namespace

std::vector<FrameNote> notesOf(const UnknownKeys& entry)
{
    std::vector<FrameNote> notes;
    if (!entry.is_object() || !entry.contains(notesKey))
        return notes;
    for (const Json& json : entry[notesKey]) {
        FrameNote& note = notes.emplace_back();
        for (const auto& [key, value] : json.items()) {
            if (key == "frame")
                note.frame = FrameIndex(value.get<std::int64_t>());
            else if (key == "text")
                note.text = value.get<std::string>();
            else
                note.unknown[key] = value;
        }
    }
    std::ranges::stable_sort(notes, {}, &FrameNote::frame);
    return notes;
}

void setNotes(UnknownKeys& entry, std::vector<FrameNote> notes)
{
    if (entry.is_object())
        entry.erase(notesKey);
    std::ranges::stable_sort(notes, {}, &FrameNote::frame);
    for (const FrameNote& note : notes) {
        Json json = Json::object();
        json["frame"] = note.frame.value;
        json["text"] = note.text;
        addUnknown(json, note.unknown);
        entry[notesKey].push_back(std::move(json));
    }
    if (entry.is_object() && entry.empty())
        entry = UnknownKeys();
}

void readNotes(const ObjectReader& reader, UnknownKeys& entry)
{
    std::vector<FrameNote> notes;
    reader.each(notesKey, [&](const Json& json, const std::string& pointer) {
        const ObjectReader own(json, pointer, reader.problems());
        FrameNote note;
        note.text = own.requiredText("text");
        if (own.find("frame") == nullptr)
            own.missing("frame");
        note.frame = FrameIndex(own.wholeNumber("frame").value_or(0));
        if (note.frame.value < 0)
            own.invalid(own.pointer("frame"), "The frame of a note is below zero", "Count frames from 0.");
        note.unknown = own.unknown({"frame", "text"});
        notes.push_back(std::move(note));
    });
    setNotes(entry, std::move(notes));
}

void addNotes(Json& json, const UnknownKeys& entry)
{
    if (entry.is_object() && entry.contains(notesKey))
        json[notesKey] = entry[notesKey];
}

} // namespace quadrille
