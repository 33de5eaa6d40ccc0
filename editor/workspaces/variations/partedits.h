// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/variationentry.h"

#include <string>
#include <vector>

namespace quadrille {

// What the user does to the curves and parts of a body, on the value that the project holds. Names that are
// given are free ones, as freeCurveName and freePartName find them.

/// Null where there is none of this name.
PartCurveEntry* findCurve(BodyPartsEntry& body, const std::string& name);
const PartCurveEntry* findCurve(const BodyPartsEntry& body, const std::string& name);
PartEntry* findPart(BodyPartsEntry& body, const std::string& name);
const PartEntry* findPart(const BodyPartsEntry& body, const std::string& name);
/// The part that all others hang on; null without one. Good until parts come or go; so for the four above.
const PartEntry* rootOf(const BodyPartsEntry& body);

/// As cutIntoParts takes them.
std::vector<PartCurve> curvesOf(const BodyPartsEntry& body);
std::vector<PartDescription> partsOf(const BodyPartsEntry& body);

/// `wanted`, or with the least number behind it that no curve has yet.
std::string freeCurveName(const BodyPartsEntry& body, const std::string& wanted);
std::string freePartName(const BodyPartsEntry& body, const std::string& wanted);

/// Names of the parts that a curve bounds.
std::vector<std::string> partsWith(const BodyPartsEntry& body, const std::string& curve);
/// Parts keep their curve.
void renameCurve(BodyPartsEntry& body, const std::string& before, const std::string& after);
/// Parts that name it keep naming it: they say what they miss.
void removeCurve(BodyPartsEntry& body, const std::string& name);
/// Parts that hang on it keep doing so.
void renamePart(BodyPartsEntry& body, const std::string& before, const std::string& after);
/// What hangs on it hangs on its parent then; its curves stay. Without the root, all parts go.
void removePart(BodyPartsEntry& body, const std::string& name);
/// Adds a part that two curves bound. A body without parts gets the one that all others hang on first. The
/// part comes behind all others.
/// \param root  the name of that. \param parent  empty: the root.
void addPart(BodyPartsEntry& body, const std::string& name, const std::string& root,
             const std::string& parent, const std::vector<std::string>& curves);

/// A name with its first "left" exchanged for "right" or the other way round, as a whole word; empty where it
/// has neither. Also knows "l"/"r" behind a separator, as in "arm_l".
std::string otherSideName(const std::string& name);

} // namespace quadrille
