// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/json.h"
#include "model/sequence/io/files/format.h"

#include <string>

namespace quadrille::cli {

/// What a sequence holds, with the keys that `quadrille info --help` lists. Reads all frames for the bounds.
/// \throws Error as MeshSequence::frame, Cancelled.
Json sequenceInfo(const std::string& path, const MeshSequence& sequence, const ImportResult& imported,
                  const Progress& progress);

/// The same for people, several lines.
std::string infoText(const Json& info);

} // namespace quadrille::cli
