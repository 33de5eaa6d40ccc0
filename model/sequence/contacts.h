// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/progress.h"
#include "model/sequence/axes.h"
#include "model/sequence/meshsequence.h"

#include <vector>

namespace quadrille {

/// When a foot counts as standing. Lengths are relative to the height of the body, so that units do not
/// matter.
struct ContactOptions
{
    UpAxis up = UpAxis::Y;
    double height = 0.01;  ///< highest height above the ground, body heights
    double speed = 0.3;    ///< highest speed, body heights a second
    double shortest = 0.1; ///< shorter contacts are left out, seconds
};

/// Proposes foot contacts from the height and speed of the lowest vertices. Feet are the parts of the surface
/// that come near the ground; two of them are called "left" and "right" by the direction in which the toes
/// point, otherwise "foot 1", "foot 2", … . The ground is where the lowest vertex mostly is.
/// \return in order of feet, then of time; frames of the sequence.
/// \throws Error as MeshSequence::frame, Cancelled.
std::vector<ContactSpan> detectContacts(const MeshSequence& sequence, const ContactOptions& options = {},
                                        const Progress& progress = {});

} // namespace quadrille
