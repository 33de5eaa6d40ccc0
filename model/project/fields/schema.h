// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/jsontext.h"

namespace quadrille {

/// The JSON schema (draft 7) of the project file, with descriptions, ranges and defaults. The file of it in
/// resources/schema is written by the test that compares both.
Json projectSchema();

} // namespace quadrille
