// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/json/objectreader.h"
#include "model/render/rendersettings.h"

namespace quadrille {

// Values of a wrong type are left at their default and reported; so are keys that are not known, as warnings.

/// The project of a document of the current version.
Project readFields(const ObjectReader& reader);
/// The keys of a document in the order in which they are written.
std::vector<std::string> documentKeys();
/// The members of a “picture”.
void readFields(const ObjectReader& reader, RenderSettings& settings);

} // namespace quadrille
