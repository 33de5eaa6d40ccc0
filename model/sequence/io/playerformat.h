// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/files/format.h"

namespace quadrille {

/// The id of the format that holds motion spaces to be played live, for games (see writePlayer). Only what is
/// made from motion spaces can be written so, not a sequence.
inline constexpr const char* playerFormat = "player";

/// \throws Error FormatCannotStore, always: says what may be written so.
[[noreturn]] void refusePlayerOfClip(const std::filesystem::path& out);

/// Knows the format; writes nothing.
class PlayerExporter : public Exporter
{
public:
    const FormatInfo& format() const override;
    /// \throws Error FormatCannotStore.
    ExportResult write(const MeshSequence& sequence, const std::filesystem::path& out,
                       const ExportOptions& options, const Progress& progress) const override;
};

} // namespace quadrille
