// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace quadrille {

/// \param reason  without the full stop. \param remedy  a sentence, or empty.
/// \throws Error ProjectInvalid, always.
[[noreturn]] inline void throwInvalid(const std::filesystem::path& file, std::string reason,
                                      std::string remedy)
{
    throw Error(ErrorCode::ProjectInvalid,
                {file, {}, {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
}

/// \overload where no file is to blame.
[[noreturn]] inline void throwInvalid(std::string reason, std::string remedy)
{
    throwInvalid({}, std::move(reason), std::move(remedy));
}

/// \param count  how many frames the sequence has. \throws Error ProjectInvalid, always.
[[noreturn]] inline void throwNoFrame(const std::string& sequence, std::int64_t frame, std::int64_t count)
{
    throwInvalid("“" + sequence + "” has no frame " + std::to_string(frame),
                 "Its frames are 0 to " + std::to_string(count - 1) + ".");
}

} // namespace quadrille
