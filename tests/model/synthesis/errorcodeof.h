// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/error.h"

#include <functional>
#include <optional>

namespace quadrille::test {

/// The code of the error that a call throws; nothing where it throws none.
inline std::optional<ErrorCode> errorCodeOf(const std::function<void()>& call)
{
    try {
        call();
    } catch (const Error& error) {
        return error.code();
    }
    return {};
}

} // namespace quadrille::test
