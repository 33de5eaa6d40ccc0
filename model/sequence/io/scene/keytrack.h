// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/scene/scene.h"

#include <span>

namespace quadrille {

/// Values of a track at a time, held before the first and after the last key. Keys within 10 µs of the time
/// count as reached, since files store times as float.
/// \param out  as many values as the track has components.
void evaluate(const KeyTrack& track, double seconds, std::span<double> out);

/// The same for a rotation: spherical interpolation, normalised.
Eigen::Quaterniond evaluateRotation(const KeyTrack& track, double seconds);

} // namespace quadrille
