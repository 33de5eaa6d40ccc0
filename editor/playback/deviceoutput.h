// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/playback/soundplayer.h"

namespace quadrille {

/// The sound device that the system uses; it is looked for when something is to be heard. Without one, or
/// with one that refuses the sound, everything stays silent.
std::unique_ptr<SoundOutput> makeDeviceOutput();

} // namespace quadrille
