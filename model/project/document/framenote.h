// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/project/document/unknownkeys.h"

#include <string>
#include <vector>

namespace quadrille {

/// What somebody wrote about a frame of a sequence or of an animation as it is shown.
struct FrameNote
{
    FrameIndex frame{0};
    std::string text;
    UnknownKeys unknown;

    bool operator==(const FrameNote&) const = default;
};

// Nothing is computed from notes. An entry carries them along with what the program does not know, in its
// `unknown`, as they stand in the file.

/// The notes of an entry in the order of their frames.
std::vector<FrameNote> notesOf(const UnknownKeys& entry);
void setNotes(UnknownKeys& entry, std::vector<FrameNote> notes);

} // namespace quadrille
