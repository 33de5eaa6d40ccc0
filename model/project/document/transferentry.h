// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/project/document/animationentry.h"
#include "model/transfer/transferclip.h"

#include <optional>
#include <string>
#include <vector>

namespace quadrille {

/// A clip that another mesh performs.
struct TransferEntry
{
    std::string name;
    std::string clip;  ///< of the template: "sequences/NAME", "animations/NAME", "variations/NAME/3", …
    NamedFrame target; ///< the mesh that performs it, in its reference pose
    /// The pose of the template that the target's is like; the most alike of its takes, mesh and clip.
    std::optional<NamedFrame> reference;
    std::vector<TrianglePair> pairs;
    FieldKind field = FieldKind::Quaternions;
    std::optional<double> scale;   ///< of the way; what the target's steps ask for
    bool correctsPose = true;      ///< limbs held otherwise than in the reference pose are brought there
    bool carriesStretch = true;    ///< how the skin stretches about the marks is carried, not rotations only
    bool marksSurroundings = true; ///< what is about the marks turns as one, not single triangles
    bool correctsContacts = true;  ///< feet that stand in the clip stand still
    /// A clip of the target's mesh that shows what the result ought to be, for evaluations; empty where none
    /// is known.
    std::string truth;
    UnknownKeys unknown;

    bool operator==(const TransferEntry&) const = default;
};

} // namespace quadrille
