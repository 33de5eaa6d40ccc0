// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <string>
#include <utility>

namespace quadrille {

/// \throws Error BadArgument, always, with what is wrong and what to do instead.
[[noreturn]] inline void refuse(std::string reason, std::string remedy)
{
    throw Error(ErrorCode::BadArgument,
                {.values = {{"reason", std::move(reason)}, {"remedy", std::move(remedy)}}});
}

} // namespace quadrille
