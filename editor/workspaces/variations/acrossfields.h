// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/fields/fieldform.h"
#include "model/project/document/variationentry.h"

#include <set>
#include <string>
#include <vector>

namespace quadrille {

class CurrentVariation;

/// The takes that the variations worked on are learned from, but for some.
std::vector<FieldItem<std::string>> takeItems(const CurrentVariation& variation,
                                              const std::set<std::string>& but);

/// The second pair of a blend of four takes: which ones, where variations lie between all four, and whether
/// blends of them are learned. \param fields  of the set that is worked on; rows are added below the others.
void addAcrossFields(FieldForm<SamplesEntry, LabelForm>& fields, CurrentVariation& variation);

/// Leaves a second pair out that can not be there any more. That is so without a blend, and where two of the
/// four takes are the same.
void dropImpossibleAcross(SamplesEntry& samples);

} // namespace quadrille
