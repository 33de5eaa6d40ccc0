// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/synthesis/clips/clipsize.h"

#include "model/core/error.h"
#include "model/core/message.h"
#include "model/core/units.h"

#include <cmath>
#include <string>

namespace quadrille {

void checkClipSize(std::int64_t frames, std::size_t vertices)
{
    constexpr double gigabyte = 1e9;
    constexpr double most = 16 * gigabyte;
    const double bytes =
        static_cast<double>(frames) * static_cast<double>(vertices) * static_cast<double>(sizeof(Vec3f));
    if (bytes <= most)
        return;
    throw Error(
        ErrorCode::BadArgument,
        {{},
         {},
         {{"reason", "A clip of " + std::to_string(frames) + " frames would take " +
                         std::to_string(std::llround(bytes / gigabyte)) + " GB of memory"},
          {"remedy", QUADRILLE_MESSAGE("Ask for a shorter one, or lower the rate of the project.")}}});
}

} // namespace quadrille
