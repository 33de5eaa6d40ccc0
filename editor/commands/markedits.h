// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/commands/changeentry.h"
#include "editor/documents/projectdocument.h"
#include "model/project/document/framenote.h"

namespace quadrille {

// Edits of what marks the frames of sequences, as those of projectedits.h.

/// The labels of several sequences in one step.
void setLabelsOfSequences(ProjectDocument& document,
                          const std::vector<std::pair<QString, std::vector<LabelSpan>>>& labels);
void setSequenceNotes(ProjectDocument& document, const QString& name, std::vector<FrameNote> notes,
                      EditPhase phase = EditPhase::Final);

} // namespace quadrille
