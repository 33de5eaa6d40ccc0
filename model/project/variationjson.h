// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/objectreader.h"

namespace quadrille {

/// The parts of a character's body, of the section “body_parts”.
BodyPartsEntry readBodyParts(const ObjectReader& reader);
Json bodyPartsToJson(const BodyPartsEntry& parts);

/// An entry of the section “variations”.
VariationEntry readVariation(const ObjectReader& reader);
Json variationToJson(const VariationEntry& variation);

} // namespace quadrille
