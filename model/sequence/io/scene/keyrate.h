// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/sequence/io/scene/scene.h"

#include <optional>
#include <vector>

namespace quadrille {

/// The rate at which a clip of a scene was captured or animated: keys of all its tracks lie on frames of this
/// rate, and on no lower one's. Rates that are nearly whole, or those of television (30000/1001), are exact.
/// \return nothing where keys are uneven, or too few or too far apart to tell.
std::optional<double> keyRate(const SceneClip& clip);

/// The rate of each clip of a scene; one that cannot tell has that of the others, where these agree.
std::vector<std::optional<double>> keyRates(const std::vector<SceneClip>& clips);

} // namespace quadrille
