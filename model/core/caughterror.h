// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

namespace quadrille {

/// The exception that a catch block handles, as an error in words of our own: an Error as it is, what the
/// system or a library threw by what it means to the user.
/// \param file  what was worked on, where the exception does not say.
/// \pre Called inside a catch block.
Error caughtError(const std::filesystem::path& file = {});

} // namespace quadrille
