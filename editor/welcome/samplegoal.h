// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QMetaType>

namespace quadrille {

/// What somebody opens the sample for.
enum class SampleGoal
{
    Play,        ///< to see a take play
    Transitions, ///< to see which frames go over into each other
    Path,        ///< to see a performance follow a path
};

} // namespace quadrille

Q_DECLARE_METATYPE(quadrille::SampleGoal)
