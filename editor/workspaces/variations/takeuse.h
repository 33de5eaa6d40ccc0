// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "model/core/units.h"
#include "model/variation/alignment.h"

#include <QString>

namespace quadrille {

/// Why some frames of a take are used, in a sentence.
QString useText(TakeUse use);
/// "12–43", counted as the timeline counts.
QString usedText(const FrameRange& frames);

} // namespace quadrille
