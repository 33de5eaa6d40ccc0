// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/project/document/framenote.h"

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
    for (const UnknownKeys& json : entry[notesKey]) {
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
        UnknownKeys json = UnknownKeys::object();
        json["frame"] = note.frame.value;
        json["text"] = note.text;
        addUnknown(json, note.unknown);
        entry[notesKey].push_back(std::move(json));
    }
    if (entry.is_object() && entry.empty())
        entry = UnknownKeys();
}

} // namespace quadrille
