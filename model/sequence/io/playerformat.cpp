// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sequence/io/playerformat.h"

#include "model/core/message.h"

namespace quadrille {

namespace {

constexpr const char* formatName = "Quadrille player";

} // namespace

void refusePlayerOfClip(const std::filesystem::path& out)
{
    throw Error(
        ErrorCode::FormatCannotStore,
        {out,
         {},
         {{"format", formatName},
          {"what", QUADRILLE_MESSAGE("a clip, only the motion spaces of a performance (“live/NAME”)")}}});
}

const FormatInfo& PlayerExporter::format() const
{
    static const FormatInfo info{.id = playerFormat, .name = formatName, .extensions = {".qplayer"}};
    return info;
}

ExportResult PlayerExporter::write(const MeshSequence& /*sequence*/, const std::filesystem::path& out,
                                   const ExportOptions& /*options*/, const Progress& /*progress*/) const
{
    refusePlayerOfClip(out);
}

} // namespace quadrille
